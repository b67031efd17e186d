// Watches how long the turns of the GUI's event loop take.
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QString>

#include <algorithm>
#include <ctime>
#include <vector>

namespace autocuts::bench {

//! Processor time that this thread has taken, in milliseconds.
inline double threadTime()
{
    timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return 1e3 * double(time.tv_sec) + 1e-6 * double(time.tv_nsec);
}

//! Notes how long each turn of the event loop takes while it lives.
class LoopWatch : public QObject
{
public:
    LoopWatch()
    {
        mClock.start();
        startTimer(0);
    }

    //! A line of JSON: gaps between turns, and the processor time that this thread took in them, in
    //! milliseconds.
    QString told(const QString &phase) const
    {
        return QStringLiteral("{\"phase\": \"%1\", \"turns\": %2, \"median_ms\": %3, \"p99_ms\": %4, "
                              "\"worst_ms\": %5, \"work_p99_ms\": %6, \"work_worst_ms\": %7}")
            .arg(phase)
            .arg(mGaps.size())
            .arg(quantile(mGaps, 0.5))
            .arg(quantile(mGaps, 0.99))
            .arg(quantile(mGaps, 1))
            .arg(quantile(mWork, 0.99))
            .arg(quantile(mWork, 1));
    }

protected:
    void timerEvent(QTimerEvent *) override
    {
        mGaps.push_back(double(mClock.nsecsElapsed()) * 1e-6);
        mClock.restart();
        const double now = threadTime();
        mWork.push_back(now - mWorked);
        mWorked = now;
    }

private:
    static double quantile(std::vector<double> times, double share)
    {
        std::sort(times.begin(), times.end());
        return times.empty() ? 0 : times[static_cast<std::size_t>(share * double(times.size() - 1))];
    }

    QElapsedTimer mClock;
    double mWorked = threadTime();
    std::vector<double> mGaps, mWork; //!< of each turn
};

} // namespace autocuts::bench
