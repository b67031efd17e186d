#include "views/panels/packpanel.h"

#include "model/document/makesnapshot.h"
#include "views/control/jobs/mapcontroller.h"
#include "views/control/session/workspace.h"
#include "views/panels/controls.h"
#include "views/ui/numbertext.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QGridLayout>
#include <QHeaderView>
#include <QIntValidator>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSpinBox>
#include <QTreeWidget>

#include <algorithm>
#include <array>

namespace autocuts {

using namespace Qt::Literals::StringLiterals;

namespace {

constexpr int tilesPerRow = 10;

} // namespace

PackPanel::PackPanel(const StudioContext &context, QWidget *parent)
    : Panel(context, tr("Open a model to pack its islands into a texture."), parent)
{
    auto *layout = new QVBoxLayout(content());
    layout->setContentsMargins(panelMargin, panelMargin, panelMargin, panelMargin);
    layout->setSpacing(rowSpacing + 2);
    auto *settings = new QWidget;
    auto *form = makeForm(settings);
    addTextureRows(form);
    addPlacingRows(form);
    layout->addWidget(settings);
    layout->addWidget(makePackButtons());
    layout->addWidget(makeHeading(tr("The map")));
    layout->addWidget(makeFigures());
    layout->addWidget(makeTiles());
    layout->addStretch();
    connect(&context.workspace, &Workspace::selectionChanged, this, [this] { refreshSoon(); });
    connect(&context.workspace, &Workspace::changed, this, [this](const ChangeEvent &event) {
        if (event.type == ChangeEvent::Type::PackingSettings || event.type == ChangeEvent::Type::Uv)
            refreshSoon();
    });
    connect(&context.map, &MapController::figuresChanged, this, [this] { refreshSoon(); });
    connect(&context.map.jobs(), &JobRunner::busyChanged, this, [this] { refreshSoon(); });
}

//! A field for texels along one side of the texture.
QComboBox *PackPanel::makeTexels(QLatin1StringView name)
{
    auto *texels = new QComboBox;
    texels->setObjectName(name);
    texels->setEditable(true);
    texels->setInsertPolicy(QComboBox::NoInsert);
    texels->setCompleter(nullptr);
    texels->setValidator(new QIntValidator(1, PackingSettings::maxTextureSize, texels));
    texels->setMinimumContentsLength(5);
    for (int size = 256; size <= 16384; size *= 2)
        texels->addItem(QString::number(size));
    connect(texels, &QComboBox::activated, this, [this, texels] { takeTexels(texels); });
    connect(texels->lineEdit(), &QLineEdit::editingFinished, this, [this, texels] { takeTexels(texels); });
    return texels;
}

void PackPanel::addTextureRows(QFormLayout *form)
{
    mTextureSize = makeTexels("textureSize"_L1);
    mTextureHeight = makeTexels("textureHeight"_L1);
    mTextureHeight->setAccessibleName(tr("Height of the texture"));
    QWidget *sides = makeRow({mTextureSize, new QLabel(u"\u00d7"_s), mTextureHeight});
    static_cast<QHBoxLayout *>(sides->layout())->setStretch(1, 0); // of the sign between them
    sides->setFocusProxy(mTextureSize);
    const QString tip =
        tr("Width and height of the texture in texels; choose or type numbers. Islands keep their "
           "shapes on a texture of another shape, so their UVs in the model's file change");
    addRow(form, tr("Texture"), sides, tip);
    mTextureSize->setToolTip(tip);
    mTextureHeight->setToolTip(tip);

    mMargin = new QSpinBox;
    mMargin->setObjectName("margin"_L1);
    mMargin->setRange(0, 1024);
    mMargin->setSuffix(tr(" px"));
    mMargin->setKeyboardTracking(false);
    connect(mMargin, &QSpinBox::valueChanged, this, [this](int margin) {
        changePackingSettings([margin](PackingSettings &s) { s.margin = margin; });
    });
    mMarginUv = makeRemark();
    mMarginUv->setObjectName("marginUv"_L1);
    mMarginUv->setWordWrap(false);
    QWidget *row = makeRow({mMargin, mMarginUv});
    row->setFocusProxy(mMargin);
    addRow(form, tr("Margin"), row,
           tr("True distance between two islands in texels, and half of it to the border of the texture"));
}

void PackPanel::addPlacingRows(QFormLayout *form)
{
    mRotation = new QComboBox;
    mRotation->setObjectName("rotation"_L1);
    mRotation->addItem(tr("None"), int(PackRotation::None));
    mRotation->addItem(tr("Half turns"), int(PackRotation::Half));
    mRotation->addItem(tr("Quarter turns"), int(PackRotation::Quarter));
    mRotation->addItem(tr("Steps of 45\u00b0"), int(PackRotation::Eighth));
    mRotation->addItem(tr("Steps of 30\u00b0"), int(PackRotation::Twelfth));
    mRotation->addItem(tr("Steps of 15\u00b0"), int(PackRotation::TwentyFourth));
    mRotation->addItem(tr("Any angle"), int(PackRotation::Free));
    connect(mRotation, &QComboBox::activated, this, [this] {
        const auto rotation = PackRotation(mRotation->currentData().toInt());
        changePackingSettings([rotation](PackingSettings &s) { s.rotation = rotation; });
    });
    addRow(form, tr("Rotation"), mRotation,
           tr("How islands may be turned to fit; those that keep their orientation are not turned"));

    mTile = new QSpinBox;
    mTile->setObjectName("tile"_L1);
    mTile->setRange(PackingSettings::firstTile, PackingSettings::lastTile);
    mTile->setKeyboardTracking(false);
    connect(mTile, &QSpinBox::valueChanged, this,
            [this](int tile) { changePackingSettings([tile](PackingSettings &s) { s.udimTile = tile; }); });
    mTilePlace = makeRemark();
    mTilePlace->setWordWrap(false);
    QWidget *row = makeRow({mTile, mTilePlace});
    row->setFocusProxy(mTile);
    addRow(form, tr("UDIM tile"), row, tr("Tile that is packed into: 1001 is the first, ten tiles in a row"));

    mBorder = new QSpinBox;
    mBorder->setObjectName("border"_L1);
    mBorder->setRange(-1, 1024);
    mBorder->setSpecialValueText(tr("Half the margin"));
    mBorder->setSuffix(tr(" px"));
    mBorder->setKeyboardTracking(false);
    connect(mBorder, &QSpinBox::valueChanged, this, [this](int border) {
        changePackingSettings([border](PackingSettings &s) { s.border = border; });
    });
    addRow(form, tr("Border"), mBorder, tr("Least distance to the border of the tile in texels"));

    mEffort = new QDoubleSpinBox;
    mEffort->setObjectName("effort"_L1);
    mEffort->setRange(0, PackingSettings::maxEffort);
    mEffort->setDecimals(1);
    mEffort->setSingleStep(0.5);
    mEffort->setSuffix(tr(" s"));
    mEffort->setKeyboardTracking(false);
    connect(mEffort, &QDoubleSpinBox::valueChanged, this, [this](double effort) {
        changePackingSettings([effort](PackingSettings &s) { s.effort = effort; });
    });
    addRow(form, tr("Effort"), mEffort,
           tr("How long to search for a better arrangement, in seconds of one processor core"));

    mKeepScale = new QCheckBox(tr("Keep each island's scale"));
    mKeepScale->setObjectName("keepScale"_L1);
    mKeepScale->setToolTip(
        tr("Every job leaves the islands the texel density that they have. Off: Pack, Unwrap and "
           "Separate give all islands of a tile the same one, as large as there is room"));
    connect(mKeepScale, &QCheckBox::clicked, this,
            [this](bool keep) { changePackingSettings([keep](PackingSettings &s) { s.keepScale = keep; }); });
    form->addRow(QString(), mKeepScale);
}

QWidget *PackPanel::makePackButtons()
{
    mPack = makeButton(tr("Pack"), "pack"_L1);
    mPackSelection = makeButton(tr("Pack selection"), "packSelection"_L1);
    explain(mPack, tr("Place all islands; locked ones stay"), {"uv.pack"});
    explain(mPackSelection, tr("Place the selected islands around the others"), {"uv.packSelection"});
    MapController &map = context().map;
    connect(mPack, &QPushButton::clicked, this, [&map] { map.pack(PackScope::All); });
    connect(mPackSelection, &QPushButton::clicked, this, [&map] { map.pack(PackScope::Selection); });
    return makeRow({mPack, mPackSelection});
}

QWidget *PackPanel::makeFigures()
{
    auto *box = new QWidget;
    auto *grid = new QGridLayout(box);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setVerticalSpacing(2);
    mEfficiency = addFigure(grid, 0, 0, tr("Efficiency"),
                            tr("Share of the texture that islands cover; of all tiles in use"));
    mGutter =
        addFigure(grid, 1, 0, tr("Smallest gutter"), tr("Smallest distance between two islands, in texels"));
    mToBorder = addFigure(grid, 2, 0, tr("To the border"),
                          tr("Smallest distance of an island to the border of its tile, in texels"));
    mInside = addFigure(grid, 3, 0, tr("In the texture"),
                        tr("Whether all islands lie in tile 1001, or in tiles at all"));
    mEfficiency->setObjectName("efficiency"_L1);
    mGutter->setObjectName("gutter"_L1);
    grid->setColumnStretch(1, 1);
    return box;
}

//! The figures of each tile; a single first one has those of the whole map.
QWidget *PackPanel::makeTiles()
{
    mTiles = new QTreeWidget;
    mTiles->setObjectName("tiles"_L1);
    mTiles->setAccessibleName(tr("Tiles in use"));
    mTiles->setHeaderLabels({tr("Tile"), tr("Islands"), tr("Efficiency"), tr("px per unit")});
    mTiles->setToolTip(tr("The UDIM tiles to which islands belong: how many, what share of the tile they "
                          "cover, and their texel density"));
    mTiles->setRootIsDecorated(false);
    mTiles->setUniformRowHeights(true);
    mTiles->setSelectionMode(QAbstractItemView::NoSelection);
    mTiles->setMaximumHeight(8 * fontMetrics().height());
    mTiles->hide();
    return mTiles;
}

void PackPanel::showTiles(const std::vector<metrics::TileFigures> &tiles, int textureSize)
{
    QList<QTreeWidgetItem *> rows;
    std::array<QString, 4> longest;
    for (const metrics::TileFigures &tile : tiles) {
        const QStringList texts{QString::number(tile.tile), countText(tile.charts),
                                percentText(tile.efficiency), significantText(tile.density * textureSize, 4)};
        auto *row = new QTreeWidgetItem(texts);
        for (int column = 0; column < texts.size(); ++column) {
            QString &widest = longest[static_cast<std::size_t>(column)];
            if (texts[column].size() > widest.size())
                widest = texts[column];
            if (column > 0)
                row->setTextAlignment(column, Qt::AlignRight | Qt::AlignVCenter);
        }
        rows << row;
    }
    mTiles->clear();
    mTiles->addTopLevelItems(rows);
    fitTileColumns(longest);
    const bool onlyFirst = tiles.size() == 1 && tiles.front().tile == PackingSettings::firstTile;
    mTiles->setVisible(!tiles.empty() && !onlyFirst);
}

//! Digits are of one width: measuring every row takes long where there are many.
void PackPanel::fitTileColumns(std::span<const QString> longest)
{
    const int margin = 2 * (mTiles->style()->pixelMetric(QStyle::PM_FocusFrameHMargin, nullptr, mTiles) + 1);
    QHeaderView &header = *mTiles->header();
    for (int column = 0; column < std::ssize(longest); ++column) {
        const int text =
            mTiles->fontMetrics().horizontalAdvance(longest[static_cast<std::size_t>(column)]) + margin;
        header.resizeSection(column, std::max(text, header.sectionSizeHint(column)));
    }
}

//! Takes the number of one of the two fields; the other one may not follow the document yet.
void PackPanel::takeTexels(const QComboBox *field)
{
    if (!document() || !field->lineEdit()->hasAcceptableInput()) {
        refreshSoon();
        return;
    }
    const int texels = field->currentText().toInt();
    const bool isWidth = field == mTextureSize;
    changePackingSettings([texels, isWidth](PackingSettings &settings) {
        // A square texture stays square when its width changes.
        const int height = settings.textureHeight == 0 ? texels : settings.textureHeight;
        settings.setTexture(isWidth ? texels : settings.textureSize, isWidth ? height : texels);
        settings.margin = std::min<double>(settings.margin, settings.shorterSide());
        settings.border = std::min(settings.border, std::max(0.0, 0.5 * settings.shorterSide() - 1));
    });
}

void PackPanel::refresh()
{
    showSettings(document() ? document()->packingSettings() : PackingSettings());
    showFigures();
    if (!document())
        return;
    const bool idle = !context().map.jobs().isBusy();
    const bool hasMap = hasUvs(*document());
    mPack->setEnabled(idle && hasMap);
    mPackSelection->setEnabled(idle && hasMap && !document()->selection().faces.isEmpty());
}

void PackPanel::showSettings(const PackingSettings &settings)
{
    const QSignalBlocker blockers[] = {QSignalBlocker(mTextureSize),  QSignalBlocker(mMargin),
                                       QSignalBlocker(mRotation),     QSignalBlocker(mTile),
                                       QSignalBlocker(mBorder),       QSignalBlocker(mEffort),
                                       QSignalBlocker(mTextureHeight)};
    // Text that is being typed is not overwritten.
    if (!mTextureSize->lineEdit()->hasFocus() || !mTextureSize->lineEdit()->isModified())
        mTextureSize->setEditText(QString::number(settings.textureSize));
    if (!mTextureHeight->lineEdit()->hasFocus() || !mTextureHeight->lineEdit()->isModified())
        mTextureHeight->setEditText(QString::number(settings.height()));
    mMargin->setMaximum(std::min(settings.shorterSide(), 9999));
    mMargin->setValue(static_cast<int>(settings.margin));
    mMarginUv->setText(tr("= %1 UV").arg(significantText(settings.margin / settings.textureSize, 3)));
    mRotation->setCurrentIndex(mRotation->findData(int(settings.rotation)));
    mKeepScale->setChecked(settings.keepScale);
    mBorder->setMaximum(std::clamp(settings.shorterSide() / 2 - 1, 0, 1024));
    mBorder->setValue(settings.border < 0 ? -1 : static_cast<int>(settings.border));
    mEffort->setValue(settings.effort);
    mTile->setValue(settings.udimTile);
    const int tile = settings.udimTile - PackingSettings::firstTile;
    mTilePlace->setText(tr("U %1, V %2").arg(tile % tilesPerRow).arg(tile / tilesPerRow));
}

void PackPanel::showFigures()
{
    const MapController &map = context().map;
    const MapFigures *figures = document() ? map.figures() : nullptr;
    const bool hasMap = figures && figures->metrics.charts > 0;
    const metrics::UvMetrics none;
    const metrics::UvMetrics &metrics = hasMap ? figures->metrics : none;
    const auto texels = [](double value) {
        return std::isfinite(value) ? tr("%1 px").arg(fixedText(value, 1)) : missingText();
    };
    mEfficiency->setText(percentText(metrics.packingUnit));
    mGutter->setText(texels(metrics.minGutterTexels));
    mToBorder->setText(texels(metrics.borderGutterTexels));
    mInside->setText(!hasMap                ? missingText()
                     : metrics.inUnitSquare ? tr("yes")
                     : metrics.inTiles      ? tr("in other tiles")
                                            : tr("no"));
    showTiles(metrics.tiles, figures ? figures->textureSize : 0);
    mTiles->setEnabled(map.figuresAreFresh());
    for (QLabel *label : {mEfficiency, mGutter, mToBorder, mInside})
        label->setEnabled(map.figuresAreFresh());
}

} // namespace autocuts
