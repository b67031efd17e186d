#include "views/panels/texturepanel.h"

#include "commands/edittextures.h"
#include "model/pictures/picturefiles.h"
#include "model/pictures/texturenames.h"
#include "views/control/pictures/modelpictures.h"
#include "views/control/session/proposedfolder.h"
#include "views/control/session/workspace.h"
#include "views/panels/controls.h"
#include "views/panels/lightform.h"
#include "views/panels/texturenaming.h"
#include "views/ui/preferences.h"
#include "views/ui/questions.h"
#include "views/ui/reasons.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDir>
#include <QFileInfo>
#include <QHeaderView>
#include <QLabel>
#include <QMenu>
#include <QPushButton>
#include <QSignalBlocker>
#include <QTreeWidget>
#include <QVBoxLayout>

#include <algorithm>

namespace autocuts {

using namespace Qt::Literals::StringLiterals;

namespace {

constexpr int thumbnailSide = 32;

using Order = std::array<TextureChannel, 3>;
constexpr Order orm{TextureChannel::Occlusion, TextureChannel::Roughness, TextureChannel::Metalness};
constexpr Order mra{TextureChannel::Metalness, TextureChannel::Roughness, TextureChannel::Occlusion};
constexpr Order rma{TextureChannel::Roughness, TextureChannel::Metalness, TextureChannel::Occlusion};

bool isColor(TextureChannel channel)
{
    return channel == TextureChannel::BaseColor || channel == TextureChannel::Emission;
}

} // namespace

TexturePanel::TexturePanel(const StudioContext &context, Questions &questions, QWidget *parent)
    : Panel(context, tr("Open a model to give it textures."), parent), mQuestions(questions),
      mMaterial(new QComboBox), mList(new QTreeWidget), mComponent(new QComboBox),
      mDirectX(new QCheckBox(tr("Normals for DirectX"))),
      mLight(new LightForm(context.view, context.preferences, questions))
{
    auto *layout = new QVBoxLayout(content());
    layout->setContentsMargins(panelMargin, panelMargin, panelMargin, panelMargin);
    layout->setSpacing(rowSpacing + 2);
    mMaterial->setObjectName("textureMaterial"_L1);
    mMaterial->setAccessibleName(tr("Material"));
    mMaterial->setToolTip(
        tr("The material whose pictures are listed; that of the selected face comes by itself"));
    mMaterial->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    mMaterial->setMinimumContentsLength(10);
    layout->addWidget(mMaterial);
    makeList();
    layout->addWidget(mList, 1);
    layout->addWidget(makeButtons());
    layout->addWidget(makeComponentRow());
    layout->addWidget(mDirectX);
    layout->addWidget(makeHeading(tr("In the views")));
    layout->addWidget(mLight);

    connect(mMaterial, &QComboBox::activated, this, [this] { fillChannels(); });
    connect(&context.workspace, &Workspace::documentReplaced, this, [this] { refreshSoon(); });
    connect(&context.workspace, &Workspace::changed, this, [this](const ChangeEvent &event) {
        if (event.type == ChangeEvent::Type::Textures || event.type == ChangeEvent::Type::Model)
            refreshSoon();
    });
    connect(&context.workspace, &Workspace::selectionChanged, this, &TexturePanel::followSelection);
    connect(&context.pictures, &ModelPictures::changed, this, [this] { refreshSoon(); });
    connect(&context.view, &ViewState::optionsChanged, this, [this] { refreshSoon(); });
}

void TexturePanel::makeList()
{
    mList->setObjectName("channels"_L1);
    mList->setAccessibleName(tr("Pictures of the material"));
    mList->setToolTip(tr("A double-click chooses another picture"));
    mList->setHeaderLabels({tr("Channel"), tr("Picture")});
    mList->setRootIsDecorated(false);
    mList->setUniformRowHeights(true);
    mList->setIconSize({thumbnailSide, thumbnailSide});
    mList->setMinimumHeight(3 * thumbnailSide);
    mList->header()->setStretchLastSection(true);
    mList->header()->setSectionResizeMode(0, QHeaderView::ResizeToContents);
    for (int channel = 0; channel < textureChannelCount; ++channel)
        new QTreeWidgetItem(mList, {channelName(TextureChannel(channel))});
    mList->setCurrentItem(mList->topLevelItem(0));
    connect(mList, &QTreeWidget::itemDoubleClicked, this, &TexturePanel::loadPicture);
    connect(mList, &QTreeWidget::currentItemChanged, this, &TexturePanel::refreshButtons);
}

QWidget *TexturePanel::makeButtons()
{
    mLoadFolder = makeButton(tr("Load folder…"), "loadTextureFolder"_L1);
    mLoadFolder->setToolTip(tr(
        "Finds the pictures of all materials by their names, such as wood_BaseColor.png, wood_Roughness.png "
        "or wood_Normal.1001.png"));
    connect(mLoadFolder, &QPushButton::clicked, this, &TexturePanel::loadFolder);
    mLoad = makeButton(tr("Load…"), "loadChannel"_L1);
    mLoad->setToolTip(tr("Chooses the picture of the marked channel"));
    connect(mLoad, &QPushButton::clicked, this, &TexturePanel::loadPicture);
    mPacked = makeButton(tr("Packed…"), "loadPacked"_L1);
    mPacked->setToolTip(
        tr("Loads one picture that holds three channels: in its red, its green and its blue"));
    auto *orders = new QMenu(mPacked);
    for (const auto &[text, order] : {std::pair(tr("Occlusion, roughness, metalness (ORM, glTF)"), orm),
                                      std::pair(tr("Metalness, roughness, occlusion (MRA)"), mra),
                                      std::pair(tr("Roughness, metalness, occlusion (RMA)"), rma)})
        connect(orders->addAction(text), &QAction::triggered, this, [this, order] { loadPacked(order); });
    mPacked->setMenu(orders);
    mRemove = makeButton(tr("Remove"), "removeChannel"_L1);
    mRemove->setToolTip(tr("The marked channel loses its picture, or gets back that of the model's file"));
    connect(mRemove, &QPushButton::clicked, this, &TexturePanel::removePicture);
    mDirectX->setObjectName("directX"_L1);
    mDirectX->setToolTip(tr("The green of the normal map points down, as DirectX has it; otherwise up, as in "
                            "OpenGL. The wrong one makes bumps look like dents"));
    connect(mDirectX, &QCheckBox::clicked, this, &TexturePanel::setDirectX);
    return makeRow({mLoadFolder, mLoad, mRemove}, RowWidths::AsNeeded);
}

QWidget *TexturePanel::makeComponentRow()
{
    const QString tip =
        tr("Which numbers of its picture the marked channel is: several channels may share one "
           "picture, such as occlusion in red, roughness in green and metalness in blue");
    mComponent->setObjectName("component"_L1);
    mComponent->setToolTip(tip);
    mComponent->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    mComponent->setMinimumContentsLength(5);
    connect(mComponent, &QComboBox::activated, this, &TexturePanel::chooseComponent);
    auto *label = new QLabel(tr("Taken from"));
    label->setToolTip(tip);
    label->setBuddy(mComponent);
    return makeRow({label, mComponent, mPacked}, RowWidths::AsNeeded);
}

int TexturePanel::material() const
{
    return mMaterial->count() == 0 ? -1 : mMaterial->currentData().toInt();
}

TextureChannel TexturePanel::channel() const
{
    return TextureChannel(std::max(0, mList->indexOfTopLevelItem(mList->currentItem())));
}

void TexturePanel::refresh()
{
    fillMaterials();
    fillChannels();
    mLight->refresh();
}

void TexturePanel::fillMaterials()
{
    const int shown = material();
    const QSignalBlocker blocker(mMaterial);
    mMaterial->clear();
    if (!document())
        return;
    const Scene &scene = document()->state().scene;
    for (int m = 0; m < std::ssize(scene.materialNames); ++m) {
        const QString &name = scene.materialNames[static_cast<std::size_t>(m)];
        mMaterial->addItem(name.isEmpty() ? tr("Material %1").arg(m + 1) : name, m);
    }
    const std::vector<int> &faces = scene.faceMaterial;
    if (faces.empty() || std::find(faces.begin(), faces.end(), -1) != faces.end())
        mMaterial->addItem(tr("Faces without a material"), -1);
    mMaterial->setCurrentIndex(std::max(0, mMaterial->findData(shown)));
    enableOrSay(mMaterial, mMaterial->count() > 1, tr("The model has no other material"));
}

QString TexturePanel::fileText(const TextureSet &set, TextureChannel wanted) const
{
    const auto found = set.find(wanted);
    if (found == set.end() || found->second.picture.isEmpty())
        return tr("none");
    const ChannelPicture &entry = found->second;
    const QString name = QFileInfo(QString(entry.picture.file).replace(u'\\', u'/')).fileName();
    const QString shown = !entry.picture.content.isEmpty() ? tr("in the model's file") : name;
    const QStringList parts{tr("red"), tr("green"), tr("blue"), tr("alpha")};
    return entry.component < 0 ? shown : tr("%1, %2").arg(shown, parts[entry.component]);
}

void TexturePanel::fillChannels()
{
    const TextureSet set = document() ? document()->state().textureSet(material()) : TextureSet();
    for (int c = 0; c < textureChannelCount; ++c) {
        const auto each = TextureChannel(c);
        QTreeWidgetItem *item = mList->topLevelItem(c);
        const auto found = set.find(each);
        const bool has = found != set.end() && !found->second.picture.isEmpty();
        item->setText(1, fileText(set, each));
        item->setToolTip(1, has ? found->second.picture.file : QString());
        item->setForeground(1, palette().brush(has ? QPalette::Active : QPalette::Disabled, QPalette::Text));
        QImage picture = has ? context().pictures.thumbnail(material(), each, thumbnailSide) : QImage();
        if (picture.isNull()) {
            picture = QImage(thumbnailSide, thumbnailSide, QImage::Format_ARGB32);
            picture.fill(Qt::transparent);
        }
        item->setIcon(0, QPixmap::fromImage(picture));
    }
    refreshButtons();
}

void TexturePanel::refreshButtons()
{
    const TextureSet set = document() ? document()->state().textureSet(material()) : TextureSet();
    const auto found = set.find(channel());
    const bool hasPicture = found != set.end() && !found->second.picture.isEmpty();
    enableOrSay(mRemove, hasPicture, tr("The marked channel has no picture"));
    mPacked->setEnabled(document() != nullptr);
    mComponent->clear();
    if (isColor(channel()) || channel() == TextureChannel::Normal)
        mComponent->addItem(tr("all colours"), -1);
    if (channel() != TextureChannel::Normal) {
        const std::array names{tr("red"), tr("green"), tr("blue"), tr("alpha")};
        for (int component = 0; component < std::ssize(names); ++component)
            mComponent->addItem(names[static_cast<std::size_t>(component)], component);
    }
    enableOrSay(mComponent, hasPicture && mComponent->count() > 1,
                hasPicture ? tr("Nothing else fits this channel") : tr("The marked channel has no picture"));
    // Of grey channels without a choice it is the red.
    mComponent->setCurrentIndex(std::max(0, mComponent->findData(hasPicture ? found->second.component : -1)));
    const auto normal = set.find(TextureChannel::Normal);
    const bool has = normal != set.end() && !normal->second.picture.isEmpty();
    enableOrSay(mDirectX, has, tr("The material has no normal map"));
    mDirectX->setChecked(has && normal->second.flipped);
}

//! The material of the first selected face.
void TexturePanel::followSelection()
{
    if (!document() || document()->selection().faces.isEmpty())
        return;
    const std::vector<int> &materials = document()->state().scene.faceMaterial;
    const auto face = static_cast<std::size_t>(document()->selection().faces.first());
    const int index = mMaterial->findData(face < materials.size() ? materials[face] : -1);
    if (index < 0 || index == mMaterial->currentIndex())
        return;
    mMaterial->setCurrentIndex(index);
    fillChannels();
}

QString TexturePanel::folderToStart() const
{
    return modelFolder(context().workspace, context().preferences);
}

void TexturePanel::loadFolder()
{
    if (!document())
        return;
    const QString folder = mQuestions.folderToOpen(tr("Load a folder of textures"), folderToStart());
    if (folder.isEmpty() || !document())
        return;
    const FolderTextures found = texturesInFolder(folder, document()->state().scene);
    if (found.pictures == 0) {
        mQuestions.showError(
            {found.left.isEmpty() ? tr("no picture in the folder has the name of a channel")
                                  : tr("no picture in the folder has the name of a material: %1")
                                        .arg(found.left.join(u", "_s)),
             folder, 0,
             tr("Names such as %1_BaseColor.png, %1_Roughness.png and %1_Normal.png are understood")
                 .arg(mMaterial->currentText())});
        return;
    }
    std::vector<TextureSet> sets = document()->state().textureSets;
    sets.resize(std::max(sets.size(), found.sets.size()));
    for (std::size_t s = 0; s < found.sets.size(); ++s)
        sets[s] = overlaid(sets[s], found.sets[s]);
    pushCommand(std::make_unique<EditTextures>(*document(), std::move(sets)));
    showSets();
    QString message = tr("Channels found: %1").arg(found.pictures);
    if (!found.left.isEmpty())
        message = tr("%1; left out: %2").arg(message, found.left.join(u", "_s));
    Q_EMIT said(message);
}

QString TexturePanel::askPicture(const QString &title)
{
    QStringList globs;
    for (const QString &suffix : pictureSuffixes())
        globs << u"*."_s + suffix;
    return mQuestions.fileToOpen(title, folderToStart(),
                                 {tr("Pictures (%1)").arg(globs.join(u' ')), tr("All files (*)")});
}

void TexturePanel::loadPicture()
{
    if (!document())
        return;
    const TextureChannel wanted = channel();
    const QString path = askPicture(tr("Load a picture: %1").arg(channelName(wanted)));
    if (path.isEmpty() || !document())
        return;
    ChannelPicture picture;
    picture.picture.file = path;
    // The name tells of tiles, of packed channels and of normals for DirectX.
    if (const auto named = textureOfName(QFileInfo(path).fileName())) {
        if (const auto found = named->channels.find(wanted); found != named->channels.end()) {
            picture = found->second;
            picture.picture.file = QFileInfo(path).dir().absoluteFilePath(named->file);
        }
    }
    changeOwn(wanted, picture);
    showSets();
}

void TexturePanel::removePicture()
{
    if (!document())
        return;
    const TextureChannel wanted = channel();
    const std::vector<TextureSet> &sets = document()->state().textureSets;
    const auto place = static_cast<std::size_t>(material() + 1);
    const bool own = place < sets.size() && sets[place].contains(wanted) && !sets[place].at(wanted).fromModel;
    if (own)
        changeOwn(wanted, std::nullopt);
    else
        changeOwn(wanted, ChannelPicture{{}, -1, false, neutralValue(wanted), false});
}

void TexturePanel::loadPacked(const Order &order)
{
    if (!document())
        return;
    const QString path = askPicture(tr("Load a picture with three channels"));
    if (path.isEmpty() || !document())
        return;
    QString file = path;
    // The name tells of tiles.
    if (const auto named = textureOfName(QFileInfo(path).fileName()))
        file = QFileInfo(path).dir().absoluteFilePath(named->file);
    const std::vector<TextureSet> &sets = document()->state().textureSets;
    const auto place = static_cast<std::size_t>(material() + 1);
    TextureSet set = place < sets.size() ? sets[place] : TextureSet();
    for (std::size_t c = 0; c < order.size(); ++c) {
        ChannelPicture picture;
        picture.picture.file = file;
        picture.component = static_cast<int>(c);
        set[order[c]] = picture;
    }
    pushCommand(EditTextures::ofMaterial(*document(), material(), std::move(set)));
    refreshSoon();
    showSets();
}

void TexturePanel::setDirectX(bool on)
{
    editPicture(TextureChannel::Normal, [on](ChannelPicture &picture) { picture.flipped = on; });
}

void TexturePanel::chooseComponent()
{
    const int component = mComponent->currentData().toInt();
    editPicture(channel(), [component](ChannelPicture &picture) { picture.component = component; });
    showSets();
}

template <class Edit>
void TexturePanel::editPicture(TextureChannel wanted, Edit edit)
{
    if (!document())
        return;
    const TextureSet set = document()->state().textureSet(material());
    const auto found = set.find(wanted);
    if (found == set.end())
        return;
    ChannelPicture picture = found->second;
    const std::vector<TextureSet> &sets = document()->state().textureSets;
    const auto place = static_cast<std::size_t>(material() + 1);
    if (place >= sets.size() || !sets[place].contains(wanted))
        picture.fromModel = true;
    if (picture.fromModel)
        picture.picture = {};
    edit(picture);
    changeOwn(wanted, picture);
}

void TexturePanel::changeOwn(TextureChannel wanted, const std::optional<ChannelPicture> &picture)
{
    const std::vector<TextureSet> &sets = document()->state().textureSets;
    const auto place = static_cast<std::size_t>(material() + 1);
    TextureSet set = place < sets.size() ? sets[place] : TextureSet();
    if (picture)
        set[wanted] = *picture;
    else
        set.erase(wanted);
    pushCommand(EditTextures::ofMaterial(*document(), material(), std::move(set)));
    refreshSoon();
}

void TexturePanel::showSets()
{
    ViewOptions options = context().view.options();
    options.pattern = Pattern::Physical;
    context().view.setOptions(options);
}

} // namespace autocuts
