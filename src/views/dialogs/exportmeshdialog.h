// Where and in which format to write the model.
#pragma once

#include "model/document/scene.h"

#include <QDialog>

class QComboBox;
class QLabel;
class QPushButton;

namespace autocuts {

class PathField;
class Questions;

//! Says of every format what it cannot hold before anything is written.
class ExportMeshDialog final : public QDialog
{
    Q_OBJECT

public:
    //! \param scene as it would be written
    //! \param path proposed, without a suffix
    ExportMeshDialog(Scene scene, const QString &path, Questions &questions);

    QString path() const;
    //! Lower-case suffix.
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
