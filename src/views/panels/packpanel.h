// The packing panel.
#pragma once

#include "model/plain/uvfigures.h"
#include "views/panels/panel.h"

#include <span>

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QFormLayout;
class QLabel;
class QPushButton;
class QSpinBox;
class QTreeWidget;

namespace autocuts {

//! Sets texture, gutter, rotation and tile, packs all or the selected islands, and shows figures of the
//! packed map.
class PackPanel final : public Panel
{
    Q_OBJECT

public:
    explicit PackPanel(const StudioContext &context, QWidget *parent = nullptr);

protected:
    void refresh() override;

private:
    void addTextureRows(QFormLayout *form);
    void addPlacingRows(QFormLayout *form);
    QWidget *makePackButtons();
    QWidget *makeFigures();
    QWidget *makeTiles();
    void showTiles(const std::vector<metrics::TileFigures> &tiles, int textureSize);
    void fitTileColumns(std::span<const QString> longest);
    QComboBox *makeTexels(QLatin1StringView name);
    void takeTexels(const QComboBox *field);
    void showSettings(const PackingSettings &settings);
    void showFigures();

    QComboBox *mTextureSize = nullptr, *mTextureHeight = nullptr;
    QSpinBox *mMargin = nullptr;
    QLabel *mMarginUv = nullptr;
    QComboBox *mRotation = nullptr;
    QCheckBox *mKeepScale = nullptr;
    QSpinBox *mTile = nullptr, *mBorder = nullptr;
    QDoubleSpinBox *mEffort = nullptr;
    QLabel *mTilePlace = nullptr;
    QPushButton *mPack = nullptr, *mPackSelection = nullptr;
    QLabel *mEfficiency = nullptr, *mGutter = nullptr, *mToBorder = nullptr, *mInside = nullptr;
    QTreeWidget *mTiles = nullptr;
};

} // namespace autocuts
