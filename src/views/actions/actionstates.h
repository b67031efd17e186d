// Which actions are possible at the moment.
#pragma once

#include "model/plain/statetoken.h"
#include "views/control/studiocontext.h"

#include <QObject>

namespace autocuts {

//! Watches document, selection, history, solver and jobs, and enables the actions whose needs are met.
class ActionStates final : public QObject
{
    Q_OBJECT

public:
    explicit ActionStates(const StudioContext &context, QObject *parent = nullptr);

    //! Mask of ActionNeed that holds now.
    int met() const;

public Q_SLOTS:
    //! Happens by itself when something changed.
    void refresh();

private:
    bool hasUvs() const;

    StudioContext mContext;
    mutable StateToken mUvToken; //!< of the state that mHasUvs is about
    mutable bool mHasUvs = false;
};

} // namespace autocuts
