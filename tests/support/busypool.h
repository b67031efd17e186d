// A pool of threads that takes on nothing else.
#pragma once

#include "views/ui/pooltask.h"

#include <QSemaphore>

#include <memory>

namespace autocuts::test {

//! Keeps all threads of the pool busy as long as it lives.
class BusyPool final
{
public:
    BusyPool()
    {
        for (int t = 0; t < backgroundPool().maxThreadCount(); ++t)
            backgroundPool().start([hold = mHold] { hold->acquire(); });
    }
    ~BusyPool() { mHold->release(backgroundPool().maxThreadCount()); }

private:
    std::shared_ptr<QSemaphore> mHold = std::make_shared<QSemaphore>();
};

} // namespace autocuts::test
