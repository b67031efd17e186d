// The panel of the user's decisions about seams.
#pragma once

#include "commands/setseamstate.h"
#include "views/panels/panel.h"

class QLabel;
class QPushButton;

namespace autocuts {

class GivenSeamForm;
class SeamPriceList;
class SliderSpin;

//! Cuts, joins and frees the selected edges, paints weights on the edges of the selected faces that keep them
//! together or attract cuts, chooses which edges become seams, and lists what each seam is worth.
class SeamPanel final : public Panel
{
    Q_OBJECT

public:
    explicit SeamPanel(const StudioContext &context, QWidget *parent = nullptr);

protected:
    void refresh() override;

private:
    enum class Paint { KeepTogether, AttractCuts, Erase };

    QWidget *makeSteering();
    QWidget *makePainting();
    QWidget *makeFigures();
    void steer(SetSeamState::Edit edit);
    void paintSelectedFaces(Paint paint);
    void keepStraight(bool on);
    void clearSteering();
    void clearPaint();
    void showCounts(const Document &document);
    void showGivenSeams();
    void showMap();
    void showPrices();
    void setSeams(SetSeamState::Edit edit, const std::vector<int> &edges);

    QLabel *mSelectedEdges = nullptr, *mSelectedFaces = nullptr;
    QPushButton *mCut = nullptr, *mJoin = nullptr, *mClear = nullptr, *mClearAll = nullptr;
    QPushButton *mStraight = nullptr, *mRelease = nullptr;
    SliderSpin *mStrength = nullptr;
    QPushButton *mKeep = nullptr, *mAttract = nullptr, *mErase = nullptr, *mErasePaint = nullptr;
    GivenSeamForm *mGiven = nullptr;
    SeamPriceList *mPrices = nullptr;
    QLabel *mGivenCount = nullptr, *mStraightCount = nullptr;
    QLabel *mCutCount = nullptr, *mHalfCutCount = nullptr, *mJoinCount = nullptr, *mKeepCount = nullptr;
    QLabel *mAttractCount = nullptr, *mSeamLength = nullptr, *mSeamNorm = nullptr, *mSeamEdges = nullptr;
};

} // namespace autocuts
