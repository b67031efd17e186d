#include "views/panels/lightform.h"

#include "model/pictures/picturefiles.h"
#include "views/panels/controls.h"
#include "views/panels/sliderspin.h"
#include "views/panels/texturenaming.h"
#include "views/ui/preferences.h"
#include "views/ui/questions.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFileInfo>
#include <QFormLayout>
#include <QPushButton>

namespace autocuts {

using namespace Qt::Literals::StringLiterals;

LightForm::LightForm(ViewState &view, const Preferences &preferences, Questions &questions, QWidget *parent)
    : QWidget(parent), mView(view), mPreferences(preferences), mQuestions(questions), mForm(makeForm(this)),
      mChannel(new QComboBox), mSurroundings(new QComboBox),
      mLoad(makeButton(tr("Load…"), "loadSurroundings"_L1)),
      mVisible(new QCheckBox(tr("Visible behind the model")))
{
    addRows();
}

template <class Edit>
void LightForm::change(Edit edit)
{
    ViewOptions options = mView.options();
    edit(options);
    options.pattern = Pattern::Physical;
    mView.setOptions(options);
}

void LightForm::addRows()
{
    mChannel->setObjectName("shownChannel"_L1);
    mChannel->addItem(tr("All, in light"), -1);
    for (int channel = 0; channel < textureChannelCount; ++channel)
        mChannel->addItem(channelName(TextureChannel(channel)), channel);
    connect(mChannel, &QComboBox::activated, this, [this] {
        const int channel = mChannel->currentData().toInt();
        change([channel](ViewOptions &options) { options.shownChannel = channel; });
    });
    addRow(mForm, tr("Show"), mChannel,
           tr("All channels under light, or one of them as it is; it also lies behind the map"));

    mSurroundings->setObjectName("surroundings"_L1);
    mSurroundings->addItem(tr("Studio"), int(Surroundings::Studio));
    mSurroundings->addItem(tr("Sky"), int(Surroundings::Sky));
    mSurroundings->addItem(tr("File"), int(Surroundings::File));
    connect(mSurroundings, &QComboBox::activated, this, &LightForm::chooseSurroundings);
    mLoad->setToolTip(tr("Choose a panorama, .hdr or .exr, whose light falls on the model"));
    connect(mLoad, &QPushButton::clicked, this, &LightForm::askSurroundings);
    auto *row = makeRow({mSurroundings, mLoad}, RowWidths::AsNeeded);
    row->setFocusProxy(mSurroundings);
    addRow(mForm, tr("Light"), row, tr("What is around the model and lights it"));

    auto *degrees = new QDoubleSpinBox;
    degrees->setDecimals(0);
    degrees->setSuffix(tr("°"));
    mTurn = new SliderSpin(SliderScale::linear(-180, 180), degrees);
    mTurn->setObjectName("lightTurn"_L1);
    connect(mTurn, &SliderSpin::edited, this,
            [this](double value) { change([value](ViewOptions &options) { options.lightTurn = value; }); });
    addRow(mForm, tr("Turn"), mTurn, tr("Turns the light about the vertical"));
    auto *stops = new QDoubleSpinBox;
    stops->setDecimals(2);
    stops->setSingleStep(0.25);
    mExposure = new SliderSpin(SliderScale::linear(-5, 5), stops);
    mExposure->setObjectName("exposure"_L1);
    connect(mExposure, &SliderSpin::edited, this,
            [this](double value) { change([value](ViewOptions &options) { options.exposure = value; }); });
    addRow(mForm, tr("Exposure"), mExposure, tr("Brightness in stops: each one doubles the light"));
    mVisible->setObjectName("showSurroundings"_L1);
    mVisible->setToolTip(tr("Shows the surroundings as the background of the 3D view"));
    connect(mVisible, &QCheckBox::clicked, this,
            [this](bool on) { change([on](ViewOptions &options) { options.showSurroundings = on; }); });
    mForm->addRow(mVisible);
}

void LightForm::chooseSurroundings()
{
    const auto kind = Surroundings(mSurroundings->currentData().toInt());
    if (kind == Surroundings::File && mView.options().surroundingsPath.isEmpty()) {
        askSurroundings();
        refresh(); // the box is reset when none is chosen
        return;
    }
    change([kind](ViewOptions &options) { options.surroundings = kind; });
}

void LightForm::askSurroundings()
{
    const QString old = mView.options().surroundingsPath;
    const QString folder = old.isEmpty() ? mPreferences.lastFolder() : QFileInfo(old).path();
    QStringList globs;
    for (const QString &suffix : pictureSuffixes())
        globs << u"*."_s + suffix;
    const QString path = mQuestions.fileToOpen(
        tr("Load surroundings"), folder,
        {tr("Panoramas (*.hdr *.exr)"), tr("Pictures (%1)").arg(globs.join(u' ')), tr("All files (*)")});
    if (path.isEmpty())
        return;
    change([&path](ViewOptions &options) {
        options.surroundings = Surroundings::File;
        options.surroundingsPath = path;
    });
}

void LightForm::refresh()
{
    const ViewOptions &options = mView.options();
    mChannel->setCurrentIndex(mChannel->findData(options.shownChannel));
    mSurroundings->setCurrentIndex(mSurroundings->findData(int(options.surroundings)));
    mSurroundings->setToolTip(options.surroundings == Surroundings::File ? options.surroundingsPath
                                                                         : QString());
    mTurn->setValue(options.lightTurn);
    mExposure->setValue(options.exposure);
    mVisible->setChecked(options.showSurroundings);
}

} // namespace autocuts
