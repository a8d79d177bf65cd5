/** Every number of the solver. Lengths are CSS pixels, times seconds, angles radians, speeds px/s. */

// Defaults of a world (D-043) -------------------------------------------------------------------------------

/** px/s². Gravity that looks like a chip dropped on a desk. More is snappier, less floats. */
export const GRAVITY = 2600
/** Restitution, 0..1. Labels are dull: with more of it a pile hops before it settles. */
export const BOUNCE = 0.18
/** Coulomb coefficient of chips and walls alike. More makes steeper piles. */
export const FRICTION = 0.4
/** 1/s. Air drag on velocity. More takes speed from long throws only: falls are short. */
export const LINEAR_DAMPING = 0.35
/** 1/s. Air drag on spin. More lets chips land flatter. */
export const ANGULAR_DAMPING = 1.4
/** px/s. An approach slower than this does not bounce. Less and a pile trembles for ever. */
export const BOUNCE_THRESHOLD = 90
/** px/s. No chip is ever faster. More asks more of the broad phase for nothing that a person can follow. */
export const MAX_SPEED = 3600

// Time (D-044) ----------------------------------------------------------------------------------------------

/**
 * s. The fixed step: frames of any length are cut into these, so that a pile does not depend on the display.
 */
export const STEP = 1 / 60
/** Sub-steps of a step. More is more exact and costs in proportion; with four, tall stacks fall. */
export const SUBSTEPS = 6

// Regimes (D-021) -------------------------------------------------------------------------------------------

/** px/s. A world in which nothing is faster is resting: one sub-step tells what the others would. */
export const RESTING_SPEED = 0.4

/**
 * px/s beyond what gravity gives. A warm start that closes a gap faster is left over from a blow and is not
 * trusted (D-025).
 */
export const BLOW_SPEED = 100
/** Most iterations of a sub-step. Fewer leave pours deeper in one another and let tall stacks sag. */
export const ITERATIONS = 16
/**
 * Most visits of contacts in a sub-step where masses differ and ask for more iterations. More may stall a
 * frame.
 */
export const UNEVEN_VISITS = 6000
/** SOR factor: an impulse is taken this much further than its contact asks. With 1 pours overlap deeper. */
export const RELAXATION = 1.3

/** Share of the fastest speed that an impulse may still change a velocity by when the iterations end. */
export const TOLERANCE = 0.03
/** px/s. Least tolerance while something moves. More lets piles creep for ever. */
export const LEAST_TOLERANCE = 0.05
/** px/s. Most tolerance. More leaves pours deeper in one another. */
export const MOST_TOLERANCE = 20
/** px/s. Tolerance of a resting world; a body in balance gains at most four times as much in a sub-step. */
export const RESTING_TOLERANCE = 0.003

// Contacts and impacts (D-022, D-023, D-024, D-025) ---------------------------------------------------------

/**
 * px. Gap up to which two bodies have a manifold before they touch: iterations may push a body this far
 * unforeseen.
 */
export const SPECULATIVE_DISTANCE = 1.5
/** Sub-steps that a contact is looked for ahead of time. More than one, as a body may gain speed in it. */
export const LOOKAHEAD = 1.25
/**
 * px of relative motion for which a manifold serves. More lags behind what rolls, less measures more often
 * (D-022).
 */
export const RECYCLE_DISTANCE = 0.25
/** px. The same at a wall, where arms that lag show in how a chip rolls and topples. */
export const WALL_RECYCLE_DISTANCE = 0.001

/** Share of its gap by which a loaded contact may close in a sub-step. All of it would chatter. */
export const LOADED_CLOSING = 0.1
/** px/s. Change by the contact solver from which a warm start was wrong, as it is after an impact (D-023). */
export const WRONG_WARM_START = 50
/**
 * Share by which friction is stronger at rest than from 10 px/s of slip on. With none a chip on a slope as
 * steep as friction is strong creeps for ever, with more it holds on steeper slopes (D-029).
 */
export const STICTION = 0.3
/**
 * Rolling resistance: twice its coefficient for a disc. Without it a disc on a level floor rolls for ten
 * seconds.
 */
export const ROLLING_RESISTANCE = 0.1
/** Share of a spin that rolling resistance takes in a sub-step while it can. More is stiffer. */
export const ROLLING_SHARE = 0.2
/**
 * The same for a body balanced on one point. Less lets it rock for seconds, more slows how it topples
 * (D-024).
 */
export const ROCKING_SHARE = 0.02
/**
 * Share of `CORE`. A body whose centre is higher over its one point than its radius and this share is
 * balanced on it, and rolling resistance would freeze it there. A body whose core is smaller than one minus
 * this share of its radius is nearly round, and never balanced (D-024).
 */
export const BALANCED_HEIGHT = 0.75
/** Most iterations over one impact. Friction and restitution of one contact agree within about twenty. */
export const IMPACT_ITERATIONS = 24
/**
 * px, share of a sub-step, or sine. Places, times and directions of an impact that differ by less count as
 * one. More lets chips that should collide slide past one another (D-012).
 */
export const IMPACT_TOLERANCE = 0.05

// Position correction and room (D-027) ----------------------------------------------------------------------

/**
 * px. Overlap that is left alone, so that contacts do not flicker, and movement that leaves contacts as they
 * are (D-022). A stack sags by this at every chip.
 */
export const LINEAR_SLOP = 0.004
/**
 * Share of an overlap that is taken out at once. More overshoots where chips crowd, less lets overlaps last.
 */
export const CORRECTION = 0.7
/** px. Most that one correction moves a contact. Less lets deep overlaps last, more makes chips jump. */
export const MAX_CORRECTION = 4
/**
 * px of overlap from which slow contacts are corrected again within a step. Chips side by side are wedged if
 * it lasts (D-027). A gap as small counts as touching, twice the overlap keeps a group awake (D-028).
 */
export const DEEP_OVERLAP = 0.02
/**
 * px/s. A contact whose bodies together are no faster is slow: its overlap is corrected again, friction and
 * rolling resistance are stronger, nothing grazes, and nobody wakes.
 */
export const SLOW_CONTACT = 10
/**
 * Most corrections of slow contacts in a step, and a quarter of it in a round of making room. Fewer let a jam
 * last.
 */
export const CORRECTIONS = 64
/**
 * px that a chip may reach into a wall at the end of a step, or that a hand outside of the stage presses it
 * there (D-013).
 */
export const WALL_OVERLAP = 0.9
/**
 * Visits of contacts in a step to make room for what moved walls or grown chips pressed together. Each takes
 * 20 ns.
 */
export const ROOM_VISITS = 200_000

// Broad phase (D-026) ---------------------------------------------------------------------------------------

/**
 * px by which a box of the broad phase is larger than its chip. More finds more pairs, less makes boxes more
 * often.
 */
export const AABB_MARGIN = 8

// Rest and waking (D-028) -----------------------------------------------------------------------------------

/**
 * px, rotation included, that a chip may be off its place while it counts as at rest. Chips on top of one
 * another that overlap by more are wedged. What is wedged goes up by this in a step (D-027).
 */
export const REST_DISTANCE = 0.5
/**
 * s that every chip of a group has to be at rest before the group sleeps, and an overlap has to last before a
 * wedged chip goes up. Room after walls moved or chips grew is made for as long. Less freezes a pile on its
 * way.
 */
export const REST_TIME = 0.5
/**
 * Share of its displacement by which a chip's place of rest follows in a step. So creep below 1 px/s is rest.
 */
export const REST_FOLLOW = 0.03

// Holding a chip (D-048) ------------------------------------------------------------------------------------

/** Hz of the mouse joint's spring. More follows the pointer more stiffly. */
export const JOINT_HERTZ = 7.5
/**
 * Most force of the mouse joint, in weights of the held chip at the default gravity or at a stronger one.
 * More crushes piles.
 */
export const JOINT_STRENGTH = 14
/** s of the pointer's way that a throw is fitted to. Less is noise, more remembers an earlier direction. */
export const THROW_WINDOW = 0.08
/** px/s of the pointer from which a chip leaves with all of its velocity; slower, with less of it. */
export const THROW_SPEED = 200
/** px/s that a chip keeps at most when it is let go, or pushed. */
export const MAX_TOSS = 1800

// Coming in, and pushes (D-051, D-052) ----------------------------------------------------------------------

/**
 * px/s at which chips come in where gravity does not bring them. More knocks the pile about that they come
 * into.
 */
export const ENTRY_SPEED = 240
/** Places along a push, at most, at which it meets chips. Fewer let a fast one pass through a small chip. */
export const PUSH_SAMPLES = 64
