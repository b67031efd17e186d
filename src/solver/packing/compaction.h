// Pushes islands apart as rigid bodies until every gutter is kept.
#pragma once

#include "solver/packing/layoutcheck.h"

namespace autocuts::packing {

//! Rigid bodies with contacts between points and edges that are nearer than the gutter. Contacts are resolved
//! one by one (projected Gauss-Seidel); each moves both bodies in proportion to their inverse masses.
class Compaction
{
public:
    //! \param layout islands may be somewhat nearer than the gutter but must not cross
    Compaction(const PackProblem &problem, Layout layout);

    const Layout &layout() const { return mLayout; }
    //! Scales all movable islands about their centres.
    void setScale(double scale);
    //! Pushes until a whole sweep finds nothing to push.
    //! \return false when this did not happen within the given number of sweeps
    [[nodiscard]] bool resolve(int sweeps, WorkMeter &work);

private:
    struct Body
    {
        double c, s; //!< cosine and sine of the angle, times the scale
        double inverseMass, inverseInertia;
        double reach; //!< radius about the centre, UV units
    };
    struct Contact
    {
        int pointBody, edgeBody;
        Vec2 point, a, b; //!< in the coordinates of the outlines
    };

    void refresh(int body);
    void collectContacts(WorkMeter &work);
    bool contactsAreStale() const;
    bool push(const Contact &contact);
    bool pushFromWalls(int body);
    void move(int body, const Vec2 &arm, const Vec2 &impulse);

    const PackProblem *mProblem;
    Layout mLayout;
    std::vector<Body> mBodies;
    Layout mCollected; //!< where everything was when the contacts were collected; no poses before
    std::vector<Contact> mContacts;
    double mTarget; //!< distance aimed at, UV units: a little more than the gutter, so that pushing ends
    double mReach;  //!< distance up to which contacts are collected, UV units
};

//! Grows the scale in small steps up to the ceiling while pushing and the exact test succeed.
//! \pre the layout is valid
//! \return the largest valid layout found
[[nodiscard]] Layout compactLayout(const PackProblem &problem, const Layout &layout, double ceiling,
                                   WorkMeter &work);

} // namespace autocuts::packing
