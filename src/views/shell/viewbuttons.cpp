#include "views/shell/viewbuttons.h"

#include "views/actions/actionregistry.h"
#include "views/canvas/canvas.h"
#include "views/canvas/mapoverlays.h"

#include <QEvent>
#include <QToolButton>
#include <QVBoxLayout>

namespace autocuts {

namespace {

// Device-independent pixels.
constexpr int iconSide = 16, distance = 4;
constexpr int belowGizmo = 96;

} // namespace

ViewButtons::ViewButtons(Canvas &canvas, const ActionRegistry &registry,
                         std::initializer_list<const char *> actions, int top)
    : QFrame(&canvas), mTop(top)
{
    setObjectName(QStringLiteral("viewButtons"));
    setCursor(Qt::ArrowCursor);
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(1, 1, 1, 1);
    column->setSpacing(0);
    for (const char *id : actions) {
        auto *button = new QToolButton;
        button->setObjectName(QLatin1StringView(id));
        button->setDefaultAction(registry.action(id));
        button->setIconSize({iconSide, iconSide});
        button->setAutoRaise(true);
        button->setFocusPolicy(Qt::NoFocus); // the view keeps the keys
        column->addWidget(button);
    }
    canvas.installEventFilter(this);
    place();
}

bool ViewButtons::eventFilter(QObject *watched, QEvent *event)
{
    if (event->type() == QEvent::Resize)
        place();
    return QFrame::eventFilter(watched, event);
}

void ViewButtons::place()
{
    const QSize size = sizeHint();
    setGeometry(parentWidget()->width() - size.width() - distance, mTop, size.width(), size.height());
}

void addViewButtons(Canvas &meshView, Canvas &uvView, const ActionRegistry &registry)
{
    new ViewButtons(meshView, registry,
                    {"view.wireframe", "view.seams", "view.steering", "view.problems", "view.grid",
                     "view.smoothShading", "view.orthographic", "view.xray"},
                    belowGizmo);
    new ViewButtons(uvView, registry,
                    {"view.fillIslands", "view.islandMarks", "view.islandNumbers", "view.rulers",
                     "view.followMap", "view.livePacking"},
                    rulerSize + distance);
}

} // namespace autocuts
