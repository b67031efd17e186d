// The dialog that asks what is to be baked.
#pragma once

#include "jobs/bakechoice.h"
#include "model/document/documentstate.h"
#include "model/document/result.h"
#include "views/ui/task.h"

#include <QDialog>

#include <memory>

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
    BakeDialog(const Document &document, const jobs::BakeChoice &last, const QStringList &filters,
               Questions &questions);
    ~BakeDialog() override;

    jobs::BakeChoice choice() const;
    //! The pictures that the choice makes.
    QStringList files() const;
    //! These files are replaced without a question.
    void setReplaceable(const QStringList &files) { mReplaceable = files; }

    void accept() override;

private:
    QWidget *makeModels(const jobs::BakeChoice &last);
    QWidget *makePictures(const jobs::BakeChoice &last);
    void addMaps(const QStringList &chosen);
    QString orFolder(const QString &file) const;
    void browseDetailed();
    void browseCage();
    void browseFolder();
    void sourceChanged();
    void proposeCage();
    void takeCage(const Result<double> &cage);
    void cageTyped();
    void endMeasuring();
    QString cageNote() const;
    void showState();
    QString sourceProblem() const;
    QString targetProblem() const;

    DocumentState mModel;
    UvMatrix mUv;
    double mTileHeight;
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
    QLabel *mCageNote, *mProblem;
    QPushButton *mPropose, *mBake, *mLive;
    bool mOwnCage;     //!< the user has typed it
    QString mMeasured; //!< the detailed model whose cage is shown; empty: none
    QStringList mReplaceable;
    QString mNotMeasured; //!< why no cage is proposed
    Task mMeasuring;      //!< how far the models are apart
};

} // namespace autocuts
