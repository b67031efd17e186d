#include "views/ui/pooltask.h"

namespace autocuts {

QThreadPool &backgroundPool()
{
    static QThreadPool pool;
    // Before the application is gone, to which results are passed.
    [[maybe_unused]] static const bool awaited = (qAddPostRoutine([] { pool.waitForDone(); }), true);
    return pool;
}

QString noMemoryText()
{
    return QCoreApplication::translate(
        "autocuts::JobRunner", "There is not enough memory. Close other programs or use a smaller model.");
}

} // namespace autocuts
