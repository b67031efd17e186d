// Waits for what follows later, without a fixed time.
#pragma once

#include "support/patience.h"

#include <QTest>
#include <QTimer>

#include <algorithm>

namespace autocuts::test {

//! Waits until none of an object's timers runs. \returns false when one still does after all patience
[[nodiscard]] inline bool timersRest(const QObject &object)
{
    const QList<QTimer *> timers = object.findChildren<QTimer *>(Qt::FindDirectChildrenOnly);
    return QTest::qWaitFor(
        [&] { return std::ranges::none_of(timers, [](const QTimer *timer) { return timer->isActive(); }); },
        patience);
}

} // namespace autocuts::test
