// Short work on a pool of threads, such as reading a picture.
#pragma once

#include <QCoreApplication>
#include <QMetaObject>
#include <QThreadPool>

#include <exception>
#include <functional>
#include <memory>
#include <new>
#include <utility>

namespace autocuts {

//! What is said when memory does not suffice. Translated, one line.
QString noMemoryText();

//! The threads for short work. Not Qt's own pool: where that is full, Qt's conversions of images wait in the
//! GUI thread until one of its threads is free, that is, until files are read. The end of the program waits
//! for it.
QThreadPool &backgroundPool();

//! Runs work on a thread of a pool and passes its result on in the GUI thread. An exception ends this work
//! only: failed() gets a message, translated, one line, in the GUI thread as well. The pool does not wait for
//! take() and failed(): they look themselves whether their receiver is still there.
template <class Work, class Take>
void runOnPool(QThreadPool &pool, Work work, Take take, std::function<void(const QString &)> failed)
{
    pool.start([work = std::move(work), take = std::move(take), failed = std::move(failed)]() mutable {
        std::function<void()> pass;
        try {
            pass = [take = std::move(take), result = std::make_shared<decltype(work())>(work())]() mutable {
                take(std::move(*result));
            };
        } catch (const std::bad_alloc &) {
            pass = [failed] { failed(noMemoryText()); };
        } catch (const std::exception &e) {
            pass = [failed, message = QString::fromUtf8(e.what())] { failed(message); };
        }
        QMetaObject::invokeMethod(QCoreApplication::instance(), std::move(pass), Qt::QueuedConnection);
    });
}

} // namespace autocuts
