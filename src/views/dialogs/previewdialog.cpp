#include "views/dialogs/previewdialog.h"

#include "model/io/files/savefile.h"
#include "model/layouts/uvexport.h"
#include "views/canvas/meshview.h"
#include "views/control/files/filecontroller.h"
#include "views/control/jobs/mapcontroller.h"
#include "views/control/session/workspace.h"
#include "views/ui/dialogsize.h"
#include "views/ui/preferences.h"
#include "views/ui/questions.h"

#include <QBuffer>
#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QFile>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QImageReader>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include <algorithm>

namespace autocuts {

using namespace Qt::Literals::StringLiterals;

namespace {

constexpr int smallest = 64, largest = 4096;
//! Texels along the side of a square of the checkerboard.
constexpr int squareTexels = 16;

//! \returns the error
QString written(const QByteArray &bytes, const QString &to)
{
    const Result<Done> saved = saveAtomically(to, bytes); // another job may look for it
    return saved ? QString() : saved.error().message;
}

//! A picture of the texture with so many texels along the longer side.
LayoutOptions textureOf(int size, double tileHeight)
{
    LayoutOptions options;
    options.size = size;
    options.tileHeight = tileHeight;
    return options;
}

//! Resamples an image to the size of the texture. \returns the error
QString resample(const QString &from, const LayoutOptions &size, const QString &to)
{
    QImageReader reader(from);
    reader.setAutoTransform(true);
    const QImage image = reader.read();
    if (image.isNull())
        return reader.errorString();
    const QImage scaled =
        image.scaled(size.width(), size.height(), Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
    QByteArray bytes;
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    return scaled.save(&buffer, "PNG") ? written(bytes, to)
                                       : PreviewDialog::tr("The picture could not be made");
}

QString drawLayout(const MeshData &mesh, const UvMatrix &uv, const LayoutOptions &options, const QString &to)
{
    const Result<QByteArray> picture = layoutPng(mesh, uv, options);
    if (!picture)
        return picture.error().message;
    return written(picture.value(), to);
}

} // namespace

PreviewDialog::PreviewDialog(const StudioContext &context, Questions &questions)
    : QDialog(questions.window()), mContext(context), mQuestions(questions),
      mTexturePath(context.view.options().texturePath),
      mViewContext{context.workspace, context.shownMap, mState,        context.preferences,
                   context.solver,    context.map,      context.files, context.actions,
                   context.pictures,  context.liveBake},
      mTools(mViewContext), mView(new MeshView(mViewContext, mTools)), mPicture(new QComboBox),
      mSize(new QComboBox), mSeams(new QCheckBox(tr("&Seams"))), mRemark(new QLabel)
{
    setWindowTitle(tr("Texture preview"));
    mView->setMinimumSize(320, 240);
    auto *layout = new QVBoxLayout(this);
    layout->addWidget(makeControls());
    layout->addWidget(mView, 1);
    auto *buttons = new QDialogButtonBox(QDialogButtonBox::Close);
    auto *save = buttons->addButton(tr("Save &picture..."), QDialogButtonBox::ActionRole);
    layout->addWidget(buttons);
    connect(save, &QPushButton::clicked, this, &PreviewDialog::save);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(mPicture, &QComboBox::activated, this, &PreviewDialog::choosePicture);
    connect(mSize, &QComboBox::currentIndexChanged, this, &PreviewDialog::refresh);
    connect(mSeams, &QCheckBox::toggled, this, &PreviewDialog::refresh);
    connect(&mJobs, &JobRunner::failed, mRemark, &QLabel::setText);
    resizeOnScreen(*this, {900, 760});
    refresh();
}

PreviewDialog::~PreviewDialog()
{
    delete mView; // destroyed before the tools that it uses
}

QWidget *PreviewDialog::makeControls()
{
    mPicture->setObjectName("picture"_L1);
    mPicture->addItem(tr("Checkerboard"), int(Picture::Checkerboard));
    mPicture->addItem(tr("Texture"), int(Picture::Texture));
    mPicture->addItem(tr("Picture of the layout"), int(Picture::Layout));
    mPicture->setCurrentIndex(mTexturePath.isEmpty() ? 0 : 1);
    mSize->setObjectName("size"_L1);
    mSize->setToolTip(tr("Texels along the longer side of the texture"));
    for (int size = smallest; size <= largest; size *= 2)
        mSize->addItem(tr("%1 px").arg(size), size);
    const PackingSettings &packing = mContext.workspace.document()->packingSettings();
    const int wanted = std::min(std::max(packing.textureSize, packing.height()), largest);
    mSize->setCurrentIndex(std::max(0, mSize->findData(wanted)));
    auto *choose = new QPushButton(tr("&Load texture..."));
    connect(choose, &QPushButton::clicked, this, &PreviewDialog::browse);
    auto *row = new QWidget;
    auto *layout = new QHBoxLayout(row);
    layout->setContentsMargins(0, 0, 0, 0);
    for (QWidget *widget : std::initializer_list<QWidget *>{mPicture, mSize, choose, mSeams})
        layout->addWidget(widget);
    layout->addWidget(mRemark, 1);
    return row;
}

PreviewDialog::Picture PreviewDialog::picture() const
{
    return Picture(mPicture->currentData().toInt());
}

int PreviewDialog::size() const
{
    return mSize->currentData().toInt();
}

void PreviewDialog::choosePicture()
{
    if (picture() == Picture::Texture && mTexturePath.isEmpty())
        browse();
    else
        refresh();
}

void PreviewDialog::browse()
{
    const QString path = mQuestions.fileToOpen(
        tr("Load texture"), mContext.preferences.lastFolder(),
        {tr("Pictures (*.png *.jpg *.jpeg *.tif *.tiff *.bmp *.tga *.webp)"), tr("All files (*)")});
    if (!path.isEmpty())
        mTexturePath = path;
    mPicture->setCurrentIndex(
        mPicture->findData(int(mTexturePath.isEmpty() ? Picture::Checkerboard : Picture::Texture)));
    refresh();
}

void PreviewDialog::refresh()
{
    mJobs.abandon();
    mRemark->clear();
    ViewOptions options;
    options.wireframe = options.grid = options.steering = options.selection = options.problems = false;
    options.smoothShading = true;
    options.seams = mSeams->isChecked();
    options.pattern = Pattern::Checker;
    const LayoutOptions texture =
        textureOf(size(), mContext.workspace.document()->packingSettings().tileHeight());
    options.checkerSize = std::max(1.0, double(texture.width()) / squareTexels);
    mState.setOptions(options);
    if (picture() == Picture::Checkerboard) {
        mRemark->setText(tr("Squares of %1 texels").arg(squareTexels));
        return;
    }
    const bool isLayout = picture() == Picture::Layout;
    const QString to = mFolder.filePath(u"%1-%2x%3-%4.png"_s.arg(isLayout ? u"layout"_s : u"texture"_s)
                                            .arg(texture.width())
                                            .arg(texture.height())
                                            .arg(qHash(isLayout ? QString() : mTexturePath)));
    if (QFile::exists(to)) {
        showTexture(to);
        return;
    }
    mRemark->setText(tr("Making the picture..."));
    const Document &document = *mContext.workspace.document();
    mJobs.start(
        windowTitle(),
        [=, from = mTexturePath, mesh = document.state().scene.mesh, uv = document.uv()](JobControl &) {
            return isLayout ? drawLayout(*mesh, uv, texture, to) : resample(from, texture, to);
        },
        [this, to](const QString &problem) {
            mRemark->setText(problem);
            if (problem.isEmpty())
                showTexture(to);
        });
}

void PreviewDialog::showTexture(const QString &path)
{
    ViewOptions options = mState.options();
    options.pattern = Pattern::Texture;
    options.texturePath = path;
    mState.setOptions(options);
}

void PreviewDialog::save()
{
    const QString path = mQuestions.fileToSave(tr("Save picture"), mContext.preferences.lastFolder(),
                                               {tr("PNG picture (*.png)")});
    if (path.isEmpty())
        return;
    QByteArray bytes;
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    if (mView->picture().save(&buffer, QFileInfo(path).suffix().toLatin1().constData()))
        mContext.files.exportBytes(path, bytes);
    else
        mQuestions.showError({tr("The picture could not be written"), path, 0,
                              tr("Choose another folder, and a name that ends with .png")});
}

} // namespace autocuts
