#include "views/ui/dialogsize.h"

#include <QScreen>
#include <QWidget>

namespace autocuts {

void resizeOnScreen(QWidget &window, const QSize &wanted)
{
    constexpr QSize frame(24, 48); // more than window frames take
    window.resize(wanted.boundedTo(window.screen()->availableSize() - frame));
}

} // namespace autocuts
