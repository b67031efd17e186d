// Islands as rigid bodies that push each other apart until every gutter is kept.
#pragma once

#include "solver/packing/layoutcheck.h"

namespace autocuts::packing {

//! Rigid bodies with contacts between points and edges that come nearer than the gutter, resolved one after
//! the other (projected Gauss-Seidel, each contact moving both bodies by their inverse masses).
class Compaction
{
public:
    //! \param layout may break the gutter a little; islands must not cross
    Compaction(const PackProblem &problem, Layout layout);

    const Layout &layout() const { return mLayout; }
    //! Makes all movable islands larger or smaller in place.
    void setScale(double scale);
    //! Pushes until a whole sweep found nothing to push.
    //! \return false when that did not happen within the given number of sweeps
    [[nodiscard]] bool resolve(int sweeps, WorkMeter &work);

private:
    struct Body
    {
        double c, s; //!< cosine and sine of the angle, times the scale
        double inverseMass, inverseInertia;
        double reach; //!< world radius
    };
    struct Contact
    {
        int pointBody, edgeBody;
        Vec2 point, a, b; //!< in the bodies' own coordinates
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
    double mTarget; //!< a little more than the gutter, so that pushing comes to an end
    double mReach;  //!< how far away a contact is collected
};

//! Grows the scale in small steps, up to the ceiling, as long as the pushes succeed and the layout passes the
//! exact test. \pre layout is valid \return the largest valid layout found
[[nodiscard]] Layout compactLayout(const PackProblem &problem, const Layout &layout, double ceiling,
                                   WorkMeter &work);

} // namespace autocuts::packing
