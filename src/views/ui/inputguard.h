// Handles wheel, keys and focus of the controls in a panel or bar.
#pragma once

#include <QObject>

namespace autocuts {

//! True for a widget that text or numbers are typed into.
bool isField(const QObject *object);

//! For the controls below a widget:
//! - Spin boxes, combo boxes and sliders use the wheel only while they have the focus; otherwise the panel
//!   scrolls.
//! - The control with the focus gets the keys that operate it (arrows; buttons Space), even when they are
//!   shortcuts of the program. Letters and Space in a number field, and Space in a list, go to the program.
//! - Enter and Escape leave a field; the view in the middle of the window gets the focus. Escape first puts
//!   the value back that was there before typing.
//! - Buttons get the focus by Tab only, so that after a click Space still runs and pauses the solver.
class InputGuard final : public QObject
{
    Q_OBJECT

public:
    //! Handles all current and future children of root. \param root becomes the parent
    explicit InputGuard(QWidget *root);

    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    void guard(QObject *object);
    bool leavesField(QWidget *field, int key);
};

} // namespace autocuts
