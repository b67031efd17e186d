#include "views/ui/pooltask.h"

namespace autocuts {

QString noMemoryText()
{
    return QCoreApplication::translate(
        "autocuts::JobRunner", "There is not enough memory. Close other programs or use a smaller model.");
}

} // namespace autocuts
