#include "cli/progressline.h"

namespace autocuts {

namespace {

constexpr int lineWidth = 78;
constexpr int leastMilliseconds = 100;

} // namespace

void ProgressLine::show(const QString &text)
{
    if (!mShow || (mWritten && mSince.elapsed() < leastMilliseconds))
        return;
    mErr << '\r' << text.left(lineWidth).leftJustified(lineWidth) << Qt::flush;
    mWritten = true;
    mSince.restart();
}

void ProgressLine::show(const JobProgress &progress)
{
    const QString stage =
        progress.stage == JobStage::Packing ? QStringLiteral("packing") : QStringLiteral("optimising");
    QString text = QStringLiteral("%1 %2 %").arg(stage).arg(100 * progress.fraction, 3, 'f', 0);
    if (progress.distortion > 0)
        text += QStringLiteral("   distortion %1   seams %2")
                    .arg(progress.distortion, 0, 'f', 4)
                    .arg(progress.seamLength, 0, 'f', 3);
    show(text);
}

void ProgressLine::clear()
{
    if (mWritten)
        mErr << '\r' << QString(lineWidth, QLatin1Char(' ')) << '\r' << Qt::flush;
    mWritten = false;
}

} // namespace autocuts
