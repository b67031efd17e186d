// The settings of the active tool, in a tool bar.
#pragma once

#include "views/canvas/tooloption.h"
#include "views/control/session/studiocontext.h"

#include <QToolBar>

#include <vector>

namespace autocuts {

class AbstractTool;
class ToolManager;

//! Shows the name of the active tool and a field for each of its options. Fields follow the tool when keys or
//! the wheel change it.
class ToolOptionBar final : public QToolBar
{
    Q_OBJECT

public:
    ToolOptionBar(const StudioContext &context, ToolManager &tools, QWidget *parent = nullptr);

private:
    void build();
    void refresh();
    QWidget *makeField(const ToolOption &option, std::size_t index);
    void set(std::size_t index, double value);

    StudioContext mContext;
    ToolManager &mTools;
    std::vector<QWidget *> mFields; //!< one per option
    bool mShowing = false;          //!< the fields are being filled
};

} // namespace autocuts
