// Which actions are possible at the moment.
#pragma once

#include "views/control/studiocontext.h"

#include <QObject>

#include <cstdint>

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
    mutable std::uint64_t mUvRevision = 0; //!< that mHasUvs is about
    mutable bool mHasUvs = false;
};

} // namespace autocuts
