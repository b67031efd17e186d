#include "views/dialogs/albedoform.h"

#include "model/pictures/picturefiles.h"
#include "views/dialogs/fieldrow.h"
#include "views/ui/colorbutton.h"
#include "views/ui/questions.h"

#include <QComboBox>
#include <QDir>
#include <QFileInfo>
#include <QFormLayout>
#include <QLineEdit>
#include <QPushButton>

#include <algorithm>

namespace autocuts {

using namespace Qt::Literals::StringLiterals;

AlbedoForm::AlbedoForm(const std::vector<UvSet> &sets, const jobs::LightMaterials &last, Questions &questions,
                       QWidget *parent)
    : QGroupBox(tr("Surface"), parent), mQuestions(questions), mForm(new QFormLayout(this)),
      mKind(new QComboBox), mUvSet(new QComboBox), mColor(new ColorButton(tr("Colour of the surface"))),
      mPicture(new QLineEdit)
{
    mKind->setObjectName("albedo"_L1);
    mKind->addItem(tr("The colours of the model"), int(Kind::Model));
    mKind->addItem(tr("One colour"), int(Kind::Color));
    mKind->addItem(tr("A picture"), int(Kind::Picture));
    mKind->setCurrentIndex(int(!last.albedoFile.isEmpty() ? Kind::Picture
                               : last.albedo              ? Kind::Color
                                                          : Kind::Model));
    mKind->setToolTip(tr("What the surface reflects; the colours of the model are those of its textures, "
                         "else of its vertices or materials"));
    mColor->setObjectName("albedoColor"_L1);
    mColor->setLinear(last.albedo.value_or(Vec3f::Constant(0.8F)));
    mColor->setAutoDefault(false);
    mPicture->setObjectName("albedoPicture"_L1);
    mPicture->setText(QDir::toNativeSeparators(last.albedoFile));
    auto *browse = new QPushButton(tr("Brow&se..."));
    browse->setObjectName("browseAlbedo"_L1);
    mPictureRow = fieldRow(mPicture, browse);
    mUvSet->setObjectName("albedoUvSet"_L1);
    mUvSet->addItem(tr("That of the light map"), QString());
    for (const UvSet &set : sets)
        mUvSet->addItem(set.name, set.name);
    mUvSet->setCurrentIndex(std::max(0, mUvSet->findData(last.albedoUvSet)));
    mForm->addRow(tr("&Reflects:"), mKind);
    mForm->addRow(tr("Colour:"), mColor);
    mForm->addRow(tr("Picture:"), mPictureRow);
    mForm->addRow(tr("For the UV set:"), mUvSet);
    connect(browse, &QPushButton::clicked, this, &AlbedoForm::browse);
    connect(mKind, &QComboBox::currentIndexChanged, this, &AlbedoForm::showState);
    connect(mPicture, &QLineEdit::textChanged, this, &AlbedoForm::changed);
    showState();
}

AlbedoForm::Kind AlbedoForm::kind() const
{
    return Kind(mKind->currentData().toInt());
}

QString AlbedoForm::picture() const
{
    return QDir::fromNativeSeparators(mPicture->text().trimmed());
}

void AlbedoForm::apply(jobs::LightMaterials &options) const
{
    options.albedo.reset();
    if (kind() == Kind::Color)
        options.albedo = mColor->linear();
    options.albedoFile = kind() == Kind::Picture ? picture() : QString();
    options.albedoUvSet = kind() == Kind::Picture ? mUvSet->currentData().toString() : QString();
}

QString AlbedoForm::problem() const
{
    return kind() != Kind::Picture || QFileInfo(picture()).isFile()
               ? QString()
               : tr("Choose the picture of the surface's colours.");
}

void AlbedoForm::browse()
{
    QStringList globs;
    for (const QString &suffix : pictureSuffixes())
        globs << u"*."_s + suffix;
    const QString path =
        mQuestions.fileToOpen(tr("Picture of the surface's colours"), picture(),
                              {tr("Pictures (%1)").arg(globs.join(u' ')), tr("All files (*)")});
    if (!path.isEmpty())
        mPicture->setText(QDir::toNativeSeparators(path));
}

void AlbedoForm::showState()
{
    mForm->setRowVisible(mColor, kind() == Kind::Color);
    mForm->setRowVisible(mPictureRow, kind() == Kind::Picture);
    mForm->setRowVisible(mUvSet, kind() == Kind::Picture);
    Q_EMIT changed();
}

} // namespace autocuts
