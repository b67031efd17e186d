// The Edit menu.
#pragma once

#include "views/control/session/studiocontext.h"

#include <QObject>

namespace autocuts {

class Questions;
class ToolManager;

//! Undo, redo, preferences and shortcuts.
class EditActions final : public QObject
{
    Q_OBJECT

public:
    EditActions(const StudioContext &context, Questions &questions, ToolManager &tools,
                QObject *parent = nullptr);

private:
    void undo();
    void redo();
    void showTexts();
    void showPreferences(bool shortcuts);

    StudioContext mContext;
    Questions &mQuestions;
    ToolManager &mTools;
};

} // namespace autocuts
