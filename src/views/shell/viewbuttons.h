// Small buttons over a view for what it shows.
#pragma once

#include <QFrame>

namespace autocuts {

class ActionRegistry;
class Canvas;

//! A column of buttons at the right border of a view, which covers the view only where the buttons are.
class ViewButtons final : public QFrame
{
    Q_OBJECT

public:
    //! \param actions ids of checkable actions with icons, from the top \param top place of the first one
    ViewButtons(Canvas &canvas, const ActionRegistry &registry, std::initializer_list<const char *> actions,
                int top);

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    void place();

    int mTop;
};

//! Puts the buttons over the 3D view and the UV view.
void addViewButtons(Canvas &meshView, Canvas &uvView, const ActionRegistry &registry);

} // namespace autocuts
