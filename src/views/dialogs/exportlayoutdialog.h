// How to draw the picture of the UV map.
#pragma once

#include "model/io/uvexport.h"

#include <QDialog>

class QCheckBox;
class QComboBox;
class QLabel;
class QPushButton;
class QSpinBox;

namespace autocuts {

class PathField;
class Questions;

//! Chooses format, size and looks.
class ExportLayoutDialog final : public QDialog
{
    Q_OBJECT

public:
    //! \param size proposed, in pixels
    //! \param path proposed, .png or .svg
    //! \param overlapping triangles of the mesh that can be hatched
    ExportLayoutDialog(int size, const QString &path, std::vector<int> overlapping, Questions &questions);

    QString path() const;
    LayoutOptions options() const;
    void accept() override;

private:
    void showFormat();
    void showPath();

    std::vector<int> mOverlapping;
    QComboBox *mFormat, *mBackground;
    QSpinBox *mSize;
    QCheckBox *mEdges, *mOverlaps;
    PathField *mPath;
    QLabel *mProblem;
    QPushButton *mExport;
};

} // namespace autocuts
