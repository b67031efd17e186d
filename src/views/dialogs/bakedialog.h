// The dialog that asks what is to be baked.
#pragma once

#include "views/control/bakechoice.h"

#include <QDialog>

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QLineEdit;
class QListWidget;
class QPushButton;
class QSpinBox;

namespace autocuts {

class Document;
class Questions;

//! Asks for a detailed model, the maps and their quality, and a folder.
class BakeDialog final : public QDialog
{
    Q_OBJECT

public:
    //! A result besides those of QDialog: the first chosen map is to follow the map while it changes.
    static constexpr int Live = 2;

    //! \param last what was chosen last time \param filters of the detailed model's file
    BakeDialog(const Document &document, const BakeChoice &last, const QStringList &filters,
               Questions &questions);

    BakeChoice choice() const;

private:
    QWidget *pathRow(QLineEdit *edit, QPushButton *browse);
    void addMaps(const QStringList &chosen);
    void browseDetailed();
    void browseFolder();
    void showState();
    QString sourceProblem() const;
    QString targetProblem() const;

    bool mHasUv;
    int mTextureSize; //!< of the document
    Questions &mQuestions;
    QStringList mFilters;
    QLineEdit *mHigh, *mFolder;
    QListWidget *mMaps;
    QComboBox *mSamples, *mDirection, *mFormat;
    QSpinBox *mWidth, *mRays, *mDilation;
    QDoubleSpinBox *mCage;
    QCheckBox *mByName, *mGreenDown;
    QLabel *mProblem;
    QPushButton *mBake, *mLive;
};

} // namespace autocuts
