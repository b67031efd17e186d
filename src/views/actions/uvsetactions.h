// The menu of UV sets.
#pragma once

#include "commands/documentcommand.h"
#include "views/control/session/studiocontext.h"

#include <QObject>

#include <functional>

namespace autocuts {

//! Connects the actions that add, choose and delete UV sets. Renaming is in the panel of UV sets.
class UvSetActions final : public QObject
{
    Q_OBJECT

public:
    explicit UvSetActions(const StudioContext &context, QObject *parent = nullptr);

private:
    using Maker = std::function<std::unique_ptr<DocumentCommand>(Document &)>;
    void connectCommand(const char *id, const Maker &make);

    StudioContext mContext;
};

} // namespace autocuts
