#include "views/panels/stretchcontrol.h"

#include "views/panels/controls.h"
#include "views/panels/sliderspin.h"
#include "views/ui/numbertext.h"

#include <QDoubleSpinBox>
#include <QLabel>
#include <QSlider>
#include <QToolButton>
#include <QVBoxLayout>

#include <array>
#include <cmath>

namespace autocuts {

using namespace Qt::Literals::StringLiterals;

namespace {

constexpr double isometric = 4; //!< D of a map without distortion
constexpr double least = 4.0001, most = 100;
//! The ends of the slider's logarithmic part, as D - 4; what is beyond gets a short way at the ends.
constexpr double low = 0.008, high = 0.45;
constexpr double endShare = 0.03;

//! Words lie under the quarters of the slider.
struct Word
{
    const char *text;
    double bound;
};
constexpr std::array words{Word{QT_TRANSLATE_NOOP("autocuts::StretchControl", "very low"), 4.015},
                           Word{QT_TRANSLATE_NOOP("autocuts::StretchControl", "low"), 4.04},
                           Word{QT_TRANSLATE_NOOP("autocuts::StretchControl", "medium"), 4.1},
                           Word{QT_TRANSLATE_NOOP("autocuts::StretchControl", "high"), 4.3}};

double boundAt(double fraction)
{
    if (fraction < endShare)
        return least + (isometric + low - least) * fraction / endShare;
    if (fraction > 1 - endShare)
        return most - (most - isometric - high) * (1 - fraction) / endShare;
    return isometric + low * std::pow(high / low, (fraction - endShare) / (1 - 2 * endShare));
}

double fractionOf(double bound)
{
    if (bound < isometric + low)
        return endShare * (bound - least) / (isometric + low - least);
    if (bound > isometric + high)
        return 1 - endShare * (most - bound) / (most - isometric - high);
    return endShare + (1 - 2 * endShare) * std::log((bound - isometric) / low) / std::log(high / low);
}

QDoubleSpinBox *makeBoundBox()
{
    auto *box = new QDoubleSpinBox;
    box->setObjectName("bound"_L1);
    box->setPrefix(u"D "_s);
    box->setDecimals(4);
    box->setSingleStep(0.01);
    return box;
}

} // namespace

StretchControl::StretchControl(QWidget *parent)
    : QWidget(parent),
      mBound(new SliderSpin({.minimum = least, .maximum = most, .toValue = boundAt, .toFraction = fractionOf},
                            makeBoundBox())),
      mPercent(makeRemark())
{
    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(2);
    layout->addWidget(mBound);
    auto *row = new QHBoxLayout;
    row->setSpacing(0);
    for (const Word &word : words) {
        auto *button = new QToolButton;
        button->setText(tr(word.text));
        button->setObjectName(QLatin1StringView(word.text));
        button->setAutoRaise(true);
        button->setCheckable(true);
        button->setFocusPolicy(Qt::TabFocus);
        button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
        button->setToolTip(tr("D at most %1, a mean stretch of %2")
                               .arg(fixedText(word.bound, 3), percentText(word.bound / isometric - 1)));
        connect(button, &QToolButton::clicked, this, [this, &word] { Q_EMIT edited(word.bound, true); });
        mWords.push_back(button);
        row->addWidget(button, 1);
    }
    layout->addLayout(row);
    mPercent->setObjectName("meanStretch"_L1);
    layout->addWidget(mPercent);
    setFocusProxy(mBound);
    connect(mBound, &SliderSpin::edited, this, &StretchControl::edited);
}

void StretchControl::setValue(double bound)
{
    mBound->setValue(bound);
    mPercent->setText(tr("Mean stretch up to %1").arg(percentText(bound / isometric - 1)));
    // The word whose quarter the slider is in.
    const auto place = static_cast<std::size_t>(std::clamp(4 * fractionOf(bound), 0.0, 3.0));
    for (std::size_t i = 0; i < mWords.size(); ++i)
        mWords[i]->setChecked(i == place);
}

} // namespace autocuts
