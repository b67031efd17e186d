#include "views/dialogs/scatterdialog.h"

#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QPushButton>
#include <QSpinBox>

#include <limits>
#include <numbers>

namespace autocuts {

using namespace Qt::Literals::StringLiterals;

namespace {

constexpr double degrees = 180 / std::numbers::pi;

QDoubleSpinBox *spinBox(QLatin1StringView name, double largest, double value, const QString &suffix,
                        const QString &tip)
{
    auto *box = new QDoubleSpinBox;
    box->setObjectName(name);
    box->setRange(0, largest);
    box->setDecimals(1);
    box->setPrefix(u"\u00b1 "_s);
    box->setSuffix(suffix);
    box->setValue(value);
    box->setToolTip(tip);
    return box;
}

} // namespace

ScatterDialog::ScatterDialog(const ScatterRanges &ranges, int textureSize, QWidget *parent)
    : QDialog(parent), mTextureSize(textureSize),
      mMove(spinBox("move"_L1, 10.0 * textureSize, ranges.move * textureSize, tr(" px"),
                    tr("How far an island may move along each axis, in texels"))),
      mAngle(spinBox("angle"_L1, 180, ranges.angle * degrees, u"\u00b0"_s,
                     tr("How far an island may turn to either side"))),
      mScale(spinBox("scale"_L1, 900, ranges.scale * 100, u" %"_s,
                     tr("How much an island may grow; it may shrink as much"))),
      mSeed(new QSpinBox)
{
    setWindowTitle(tr("Randomise islands"));
    mSeed->setObjectName("seed"_L1);
    mSeed->setRange(0, std::numeric_limits<int>::max());
    mSeed->setValue(static_cast<int>(ranges.seed));
    mSeed->setToolTip(tr("The same seed gives the same result"));
    auto *buttons = new QDialogButtonBox(QDialogButtonBox::Cancel, this);
    buttons->addButton(tr("&Randomise"), QDialogButtonBox::AcceptRole)->setDefault(true);
    auto *form = new QFormLayout(this);
    form->addRow(tr("&Move:"), mMove);
    form->addRow(tr("&Turn:"), mAngle);
    form->addRow(tr("&Scale:"), mScale);
    form->addRow(tr("S&eed:"), mSeed);
    form->addRow(buttons);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
}

ScatterRanges ScatterDialog::ranges() const
{
    ScatterRanges ranges;
    ranges.move = mMove->value() / mTextureSize;
    ranges.angle = mAngle->value() / degrees;
    ranges.scale = mScale->value() / 100;
    ranges.seed = static_cast<unsigned>(mSeed->value());
    return ranges;
}

} // namespace autocuts
