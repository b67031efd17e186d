// Keeps wheel, keys and focus of a panel's controls apart from what surrounds the panel.
#pragma once

#include <QObject>

namespace autocuts {

//! For the controls below a widget:
//! - spin boxes, combo boxes and sliders take the wheel only while they have the focus; else it scrolls,
//! - what has the focus gets the keys that it is operated with (arrows, Space), although the program has
//!   shortcuts on them,
//! - buttons take the focus by Tab only, so that Space runs and pauses after a click.
class InputGuard final : public QObject
{
    Q_OBJECT

public:
    //! Guards what is, and will be, below root. \param root becomes the parent
    explicit InputGuard(QWidget *root);

    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    void guard(QObject *object);
};

} // namespace autocuts
