// The dialog for exporting a picture of the UV layout.
#pragma once

#include "model/layouts/uvexport.h"

#include <QDialog>

class QCheckBox;
class QComboBox;
class QLabel;
class QPushButton;
class QSpinBox;

namespace autocuts {

class ColorButton;
class PathField;
class Questions;

//! The faces that the picture shows.
enum class LayoutPart { All, Shown, Selected };

//! Sets format, size, colours, bleed and what is drawn.
class ExportLayoutDialog final : public QDialog
{
    Q_OBJECT

public:
    //! \param size suggested size in pixels
    //! \param path suggested path, .png or .svg
    //! \param overlapping triangles of the mesh that may be hatched
    ExportLayoutDialog(int size, const QString &path, std::vector<int> overlapping, Questions &questions);

    //! Offers a choice of parts. \param hidden some faces are hidden \param selected some are selected
    void offerParts(bool hidden, bool selected);

    QString path() const;
    LayoutOptions options() const;
    LayoutPart part() const;
    void accept() override;

private:
    //! A colour that is used when its box is checked.
    struct OwnColor
    {
        QCheckBox *box;
        ColorButton *button;
    };
    OwnColor makeColor(const QString &text, const QString &name, const QColor &first);
    QWidget *makeColors();
    static std::optional<QColor> chosen(const OwnColor &color);
    void showFormat();
    void showPath();

    std::vector<int> mOverlapping;
    QComboBox *mFormat, *mBackground, *mPart;
    QSpinBox *mSize, *mBleed;
    QCheckBox *mFill, *mEdges, *mSeams, *mOverlaps;
    OwnColor mIslandColor, mEdgeColor, mSeamColor;
    PathField *mPath;
    QLabel *mProblem;
    QPushButton *mExport;
};

} // namespace autocuts
