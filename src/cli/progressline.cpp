#include "cli/progressline.h"

#include <QJsonDocument>
#include <QJsonObject>

namespace autocuts {

namespace {

constexpr int lineWidth = 78;
constexpr int leastMilliseconds = 100;

} // namespace

QString ProgressLine::wordOf(JobStage stage) const
{
    switch (stage) {
    case JobStage::Preparing:
        return QStringLiteral("preparing");
    case JobStage::Packing:
        return QStringLiteral("packing");
    default:
        return mWorking;
    }
}

bool ProgressLine::isDue()
{
    const bool waits = mWritten || mStyle == ProgressStyle::Lines;
    const int least = mStyle == ProgressStyle::Lines ? mSeldom : leastMilliseconds;
    if (mStyle == ProgressStyle::None || (waits && mSince.elapsed() < least))
        return false;
    mWritten = true;
    mSince.restart();
    return true;
}

void ProgressLine::show(const QString &text)
{
    if (!isDue())
        return;
    if (mStyle == ProgressStyle::Lines)
        mErr << text << Qt::endl;
    else
        mErr << '\r' << text.left(lineWidth).leftJustified(lineWidth) << Qt::flush;
}

void ProgressLine::show(const JobProgress &progress)
{
    const QString stage = wordOf(progress.stage);
    if (mStyle == ProgressStyle::Json) {
        if (!isDue())
            return;
        QJsonObject event{{QStringLiteral("stage"), stage}, {QStringLiteral("fraction"), progress.fraction}};
        if (progress.distortion > 0) {
            event.insert(QStringLiteral("distortion"), progress.distortion);
            event.insert(QStringLiteral("seam_length"), progress.seamLength);
        }
        mErr << QString::fromUtf8(QJsonDocument(event).toJson(QJsonDocument::Compact)) << Qt::endl;
        return;
    }
    QString text = QStringLiteral("%1 %2 %").arg(stage).arg(100 * progress.fraction, 3, 'f', 0);
    if (progress.distortion > 0)
        text += QStringLiteral("   distortion %1   seams %2")
                    .arg(progress.distortion, 0, 'f', 4)
                    .arg(progress.seamLength, 0, 'f', 3);
    show(text);
}

void ProgressLine::clear()
{
    if (mStyle == ProgressStyle::Line && mWritten)
        mErr << '\r' << QString(lineWidth, QLatin1Char(' ')) << '\r' << Qt::flush;
    mWritten = false;
}

} // namespace autocuts
