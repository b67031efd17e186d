// Watches how long the turns of the GUI's event loop take, and which events take it.
#pragma once

#include <QApplication>
#include <QElapsedTimer>
#include <QMetaEnum>
#include <QObject>
#include <QString>

#include <algorithm>
#include <ctime>
#include <utility>
#include <vector>

namespace autocuts::bench {

//! Processor time that this thread has taken, in milliseconds.
inline double threadTime()
{
    timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return 1e3 * double(time.tv_sec) + 1e-6 * double(time.tv_nsec);
}

//! Knows how long each event took since the last question, without the events that it caused itself.
class TimedApplication : public QApplication
{
public:
    //! An event, by its receiver and type, and its milliseconds.
    using Share = std::pair<QString, double>;

    using QApplication::QApplication;

    bool notify(QObject *receiver, QEvent *event) override
    {
        // The receiver may be gone afterwards.
        const char *const room = receiver->metaObject()->className();
        const QEvent::Type type = event->type();
        QElapsedTimer clock;
        clock.start();
        const double before = std::exchange(mInside, 0);
        const bool result = QApplication::notify(receiver, event);
        const double all = double(clock.nsecsElapsed()) * 1e-6;
        if (const double own = all - mInside; own > 1)
            mShares.emplace_back(QLatin1StringView(room) + u' ' +
                                     QLatin1StringView(QMetaEnum::fromType<QEvent::Type>().valueToKey(type)),
                                 own);
        mInside = before + all;
        return result;
    }

    //! The events that took more than a millisecond, and starts anew.
    std::vector<Share> takeShares() { return std::exchange(mShares, {}); }

private:
    double mInside = 0; //!< of the events inside the one that runs
    std::vector<Share> mShares;
};

//! Notes how long each turn of the event loop takes while it lives.
class LoopWatch : public QObject
{
public:
    LoopWatch()
    {
        mClock.start();
        startTimer(0);
    }

    //! A line of JSON: gaps between turns, the processor time that this thread took in them, and the events
    //! of the worst one if the application is a TimedApplication, in milliseconds.
    QString told(const QString &phase) const
    {
        return QStringLiteral("{\"phase\": \"%1\", \"turns\": %2, \"median_ms\": %3, \"p99_ms\": %4, "
                              "\"worst_ms\": %5, \"work_p99_ms\": %6, \"work_worst_ms\": %7, "
                              "\"worst_events\": \"%8\"}")
            .arg(phase)
            .arg(mGaps.size())
            .arg(quantile(mGaps, 0.5))
            .arg(quantile(mGaps, 0.99))
            .arg(quantile(mGaps, 1))
            .arg(quantile(mWork, 0.99))
            .arg(quantile(mWork, 1))
            .arg(mWorst.join(QStringLiteral(", ")));
    }

protected:
    void timerEvent(QTimerEvent *) override
    {
        mGaps.push_back(double(mClock.nsecsElapsed()) * 1e-6);
        noteWorst();
        mClock.restart();
        const double now = threadTime();
        mWork.push_back(now - mWorked);
        mWorked = now;
    }

private:
    void noteWorst()
    {
        auto *const application = dynamic_cast<TimedApplication *>(QCoreApplication::instance());
        if (!application)
            return;
        const std::vector<TimedApplication::Share> shares = application->takeShares();
        if (mGaps.back() <= mLongest)
            return;
        mLongest = mGaps.back();
        mWorst.clear();
        for (const auto &[event, milliseconds] : shares)
            mWorst += event + u' ' + QString::number(milliseconds, 'f', 1);
    }

    static double quantile(std::vector<double> times, double share)
    {
        std::sort(times.begin(), times.end());
        return times.empty() ? 0 : times[static_cast<std::size_t>(share * double(times.size() - 1))];
    }

    QElapsedTimer mClock;
    double mWorked = threadTime();
    double mLongest = 0;              //!< of all turns
    QStringList mWorst;               //!< the events of the longest turn
    std::vector<double> mGaps, mWork; //!< of each turn
};

} // namespace autocuts::bench
