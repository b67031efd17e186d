// The dialog for exporting the model.
#pragma once

#include "model/document/scene.h"

#include <QDialog>

class QComboBox;
class QLabel;
class QPushButton;

namespace autocuts {

class PathField;
class Questions;

//! Sets path and format, and lists what the format cannot hold before anything is written.
class ExportMeshDialog final : public QDialog
{
    Q_OBJECT

public:
    //! \param scene the scene to write
    //! \param path suggested path without suffix
    ExportMeshDialog(Scene scene, const QString &path, Questions &questions);

    QString path() const;
    //! Lower-case suffix of the format.
    QString format() const;
    void setFormat(const QString &format);
    //! What the chosen format cannot hold, one line each.
    QStringList losses() const;
    void accept() override;

private:
    void showFormat();
    void showPath();

    Scene mScene;
    QComboBox *mFormat;
    PathField *mPath;
    QLabel *mLosses, *mProblem;
    QPushButton *mExport;
};

} // namespace autocuts
