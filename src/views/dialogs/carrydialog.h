// The dialog that asks how textures are to be carried over to the map.
#pragma once

#include "jobs/carrychoice.h"

#include <QDialog>

class QComboBox;
class QLabel;
class QLineEdit;
class QPushButton;
class QSpinBox;
class QTreeWidget;

namespace autocuts {

class Document;
class Questions;
namespace jobs {
struct CarryPlan;
}

//! Asks for the map that the textures are for, the files and their size; shows what will be written.
class CarryDialog final : public QDialog
{
    Q_OBJECT

public:
    //! \param last what was chosen last time; without a folder or a suffix, some are proposed
    //! \param folder the one that is proposed where the textures have none
    //! \param filters of the other model's file
    CarryDialog(const Document &document, const jobs::CarryChoice &last, const QString &folder,
                const QStringList &filters, Questions &questions);

    jobs::CarryChoice choice() const;
    //! Asks before files are replaced.
    void accept() override;

private:
    void addSources(const jobs::CarryChoice &last);
    void addFormats(const jobs::CarryChoice &last);
    void fillForm();
    void browseFile();
    void browseFolder();
    void showState();
    void showPlan(const jobs::CarryPlan &plan);
    jobs::CarryPlan plan() const;
    QString sourceProblem() const;
    QString targetProblem(const jobs::CarryPlan &plan) const;

    const Document &mDocument;
    Questions &mQuestions;
    QStringList mFilters;
    bool mTiled = false;
    QComboBox *mFrom, *mUvSet, *mSize, *mFormat;
    QLineEdit *mFile, *mFolder, *mSuffix;
    QWidget *mFileRow, *mFolderRow;
    QSpinBox *mMargin;
    QTreeWidget *mList;
    QLabel *mProblem;
    QPushButton *mCarry;
};

} // namespace autocuts
