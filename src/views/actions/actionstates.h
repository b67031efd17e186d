// Enables and disables actions.
#pragma once

#include "model/plain/statetoken.h"
#include "views/control/session/studiocontext.h"

#include <QObject>

namespace autocuts {

//! Watches document, selection, history, solver and jobs, and enables the actions whose conditions are met.
class ActionStates final : public QObject
{
    Q_OBJECT

public:
    explicit ActionStates(const StudioContext &context, QObject *parent = nullptr);

    //! The mask of ActionNeed conditions that are met now.
    int met() const;

public Q_SLOTS:
    //! Called automatically after every change.
    void refresh();

private:
    bool hasUvs() const;

    StudioContext mContext;
    mutable StateToken mUvToken; //!< the state for which mHasUvs was computed
    mutable bool mHasUvs = false;
};

} // namespace autocuts
