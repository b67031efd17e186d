// The dialog that asks what is to be baked.
#pragma once

#include "model/document/documentstate.h"
#include "views/control/bakechoice.h"
#include "views/control/jobrunner.h"

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
    QWidget *makeModels(const BakeChoice &last);
    QWidget *makePictures(const BakeChoice &last);
    QWidget *pathRow(QLineEdit *edit, QPushButton *browse);
    void addMaps(const QStringList &chosen);
    void browseDetailed();
    void browseCage();
    void browseFolder();
    void proposeCage();
    void showState();
    QString sourceProblem() const;
    QString targetProblem() const;

    DocumentState mModel;
    bool mHasUv;
    int mTextureSize; //!< of the document
    Questions &mQuestions;
    QStringList mFilters;
    QLineEdit *mHigh, *mCageFile, *mFolder;
    QListWidget *mMaps;
    QComboBox *mSamples, *mDirection, *mColors, *mFormat;
    QSpinBox *mWidth, *mRays, *mDilation;
    QDoubleSpinBox *mCage, *mReach, *mCurvature, *mThickness;
    QCheckBox *mByName, *mGreenDown, *mPutOn;
    QLabel *mProblem;
    QPushButton *mPropose, *mBake, *mLive;
    QString mMeasured; //!< why no cage is proposed
    JobRunner mMeasuring{JobRunner::OnCancel::LetGo};
};

} // namespace autocuts
