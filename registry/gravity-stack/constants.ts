/** Every number of the simulation, with its unit and its reason. Lengths are CSS pixels, times seconds, angles radians. */

/** px/s², about what a chip dropped on a desk looks like on a screen. */
export const GRAVITY = 2600
/** Restitution, 0..1: chips are dull. */
export const BOUNCE = 0.18
/** Coulomb coefficient between chips, and between a chip and the stage. */
export const FRICTION = 0.4
/** 1/s, air drag on the velocity and on the spin. */
export const LINEAR_DAMPING = 0.35
export const ANGULAR_DAMPING = 1.4
/**
 * Rolling resistance: twice its coefficient for a disc, and the share of a spin by which it grows in a sub-step until it holds.
 * Of a long chip that leans on others it has a lever of up to 0.017 of the length, which no rolling has: it also holds back the rocking that lagging arms feed.
 * Without it a disc on a level floor rolls on for ten seconds, and a pill rocks as long.
 */
export const ROLLING = 0.1
export const ROLLING_SHARE = 0.2
/** Share by which friction is more at rest. */
export const STICTION = 0.2
/** px/s of slip, or of an end about the middle, below which friction and rolling resistance grow; that by as much again at rest for a disc. */
export const SLOW = 20
/** What stands up on one point is not held by it, or it would lean, on nothing: it is only braked, by so much of that share, as the solver feeds what rocks. */
export const ROCKING_SHARE = 0.1
/** It stands if that point is farther from its centre than so much of its corners' radius and so much of what is within them: what is nearly round never does. */
export const UPRIGHT_ROUND = 1.05
export const UPRIGHT_CORE = 0.75
/** px/s of approach below which nothing bounces: above it a pile would never come to rest. */
export const BOUNCE_THRESHOLD = 90
/** px/s, the fastest a chip ever moves. */
export const MAX_SPEED = 3600

/** s, the fixed step. Frames of any length are cut into these, so that the pile never depends on the display. */
export const STEP = 1 / 60
/** Sub-steps of a step for an island in motion. More is more exact and dearer. */
export const SUBSTEPS = 6
/**
 * Most velocity sweeps of a sub-step: few while a chip of the island is faster than this, px/s, as the next sub-step sees
 * other contacts anyway; many when what is left is to stand.
 */
export const SWEEPS = 12
export const SWEEPS_LEAST = 2
export const SWEEPS_LIVELY = 8
export const LIVELY = 100
/** The same where something is crushed at that speed: eight don't tell of it soon enough at the foot of a large pile. */
export const SWEEPS_CRUSHED = 16
/** The same where an island has masses of a larger ratio than this. */
export const SWEEPS_UNEVEN = 300
export const UNEVEN = 20
/** How many of those sweeps come before the first that is over-relaxed. */
export const SWEEPS_PLAIN = 8
/** Contacts that the sweeps of a sub-step may visit in an island slower than `LIVELY`, but for its first `SWEEPS_LEAST`: a large pile spreads its sweeps over the frames. */
export const SWEEP_BUDGET = 16_000
/**
 * Over-relaxation of the sweeps where an island has more contacts, and something faster (px/s), than this: loads get through a pile in fewer of
 * them. A few contacts are solved at once without, and what hardly moves would ring.
 */
export const RELAXATION = 1.3
export const CROWDED = 12
export const CREEP = 3
/** Times the speed that an island, or a cluster of impacts, began with: from there on over-relaxed sweeps are running away. */
export const RUNAWAY = 8
/** px of overlap from which a contact is not over-relaxed, nor its island where that is slow; one of very unequal masses is no further than others. */
export const CRUSHED = 1.5
/**
 * px/s, change of velocity in a sweep at which the sweeps of a sub-step end: a share of the fastest body's speed, and its
 * bounds. Loose while things fly about, tight when they creep: creep from unfinished sweeps would never end.
 */
export const TOLERANCE_SHARE = 0.01
export const TOLERANCE_SHARE_LIVELY = 0.02
export const TOLERANCE_LEAST = 0.05
export const TOLERANCE_MOST = 10
/**
 * px/s, and px/s²: an island in which nothing is faster, or accelerates more, is in balance: the step's other sub-steps would repeat
 * this one. What starts no faster than that would count as at rest anyway: half a pixel in half a second.
 */
export const BALANCE = 0.4
export const BALANCE_GAIN = 4
/** px/s, the tolerance where nothing is faster than that: one sub-step a step has time to be exact. */
export const TOLERANCE_STILL = 0.003

/** px/s, change of velocity by the sweeps beyond which the warm start of a body counts as wrong for it; where gravity is more than usual it grows alike. */
export const MISJUDGED = 50

/** px, overlap that the position sweep leaves alone, so that contacts don't flicker. */
export const SLOP = 0.004
/**
 * px, overlap beyond the slop at which an island goes on being parted at the end of a step, if nothing in it is faster than this,
 * px/s, and how often: a jam comes apart, while a pile that still settles would be stirred.
 */
export const DEEP = 0.02
export const JAMMED = 10
export const PARTINGS = 64
/** Steps in a row that an island may stay deep for all that; from then on so many contacts are visited for it in a step, and what is wedged between others goes up. */
export const PATIENCE = 30
export const PARTING_BUDGET = 100_000
/** px of overlap that partings have to leave for two chips to count as wedged. */
export const WEDGED = 0.5
/** Share of the remaining overlap that is taken out before a sub-step, and by a position sweep at the end of a step. */
export const PUSH = 0.5
export const PUSH_LAST = 0.9
/** px, the most a position sweep moves a contact at once: keeps the recovery from deep overlap gentle. */
export const MAX_PUSH = 4
/** px, the deepest that a chip may be pressed into a wall at the end of a step. */
export const WALL_GIVE = 0.9
/** Share of the gap of a contact that carries a load, by which it may close in a sub-step: less chatter than all of it. */
export const CLOSING_SHARE = 0.1
/** px, gap below which a pair is handed to the solver before it touches, as what the sweeps do to a chip in a sub-step is not foreseen. */
export const MARGIN = 1.5
/** Sub-steps ahead that a pair is looked for: a little more than one, as a body may gain speed in it. */
export const AHEAD = 1.25
/**
 * px of relative motion after which a touching pair is measured again, the same where an island rocks, its fastest chip faster than what gravity
 * gives in this time, s, and not lively, as arms that lag feed nearly round chips that rock, and that of a chip at a wall.
 */
export const REFRESH = 0.5
export const REFRESH_ROCKING = 0.05
export const ROCKING = 1 / GRAVITY
export const WALL_REFRESH = 0.001
/** px of relative motion since the last measurement up to which a pair's gap is taken from its bound. */
export const LOOSE = 2
/** px/s, over `AHEAD` sub-steps: 0.005 px with six. A chip that moved less since its contacts were last looked at leaves them as they are. */
export const STANDING = 1.44
/**
 * px, and share of the way of a step, by which a broad-phase box is larger than its chip, and px from a box to a wall up to which the two are a pair: a
 * chip that is knocked into a spin meets the wall within the step.
 */
export const SKIN = 5
export const SKIN_SHARE = 0.1
export const WALL_SKIN = 20

/** px/s, and share of the hardest hit: change of velocity below which the sweeps over simultaneous impacts stop. */
export const IMPACT_TOLERANCE = 2
export const IMPACT_SHARE = 0.1
/** Rounds of impacts in a sub-step: what is hit may hit another. Of lively chips, from this restitution up, more bounces are told apart. */
export const IMPACT_ROUNDS_DULL = 4
export const IMPACT_ROUNDS = 6
/** Restitution from which that is so, and from which a step is held to the energy that it began with. */
export const LIVELY_BOUNCE = 0.5
/** Most sweeps over one cluster of impacts. */
export const IMPACT_SWEEPS = 24
/** px/s, and share of the hardest hit: approach from which an impact is passed on to a touching neighbour. */
export const IMPACT_SPREAD = 5
export const IMPACT_SPREAD_SHARE = 0.1
/** px/s: what it comes to in a sub-step, 0.2 px with six, is the gap up to which a neighbour counts as touching when an impact is passed on. */
export const IMPACT_NEAR = 72
/** px that are left when the first of two hits comes, up to which they count as one. */
export const IMPACT_TOUCH = 0.05

/** px: two chips that would miss if they were this much farther apart slide past one another. See D-012. */
export const GRAZE = 0.1
/** Sine of the angle up to which a motion counts as along a surface. */
export const GRAZE_SLOPE = 0.1

/** px of displacement (rotation included) that a chip may show while it counts as at rest, and s for which it must. */
export const REST_DISTANCE = 0.5
export const REST_TIME = 0.5
/** Contacts visited in a step to part what moved walls or grown chips have pressed together. */
export const STRAIGHTENING = 20_000
/** How often a step looks for new pairs while it makes room, for at most `PATIENCE` steps, for what moved walls or grown chips have pressed together. */
export const ROOM_ROUNDS = 8
/** How many steps' worth of that a world in which no time passes does at once. */
export const ROOM_STEPS = 6
/** Share of that displacement by which the place it is counted from follows in a step: creep of less than 1 px/s is rest. */
export const FOLLOW = 0.03

/** Hz, damping ratio and force limit (in weights of the chip, at this gravity, px/s², where there is less) of the soft constraint that holds a grabbed chip. */
export const GRAB_HERTZ = 7.5
export const GRAB_DAMPING = 1
export const GRAB_STRENGTH = 14
export const GRAB_GRAVITY = 500
/** ms that a finger rests on a chip, or px that it moves aside, before it holds the chip instead of scrolling the page. */
export const TOUCH_HOLD = 180
export const TOUCH_DRAG_START = 8
/** px by which a hand outside of the stage presses its chip against the wall: friction then calms a swinging chip. See D-013. */
export const GRAB_PRESS = 1
/** px, a little more than a chip that merely hangs there lags behind the pointer. */
export const GRAB_SAG = 4
/** s of the pointer's way that a throw is fitted to, and px that the grabbed point may be off beside what it trails at that speed. */
export const THROW_WINDOW = 0.08
export const THROW_SLACK = 16
/** s after the pointer's last move until word of the same place counts as a stop. */
export const THROW_PAUSE = 0.025
/** px/s of the pointer from which a chip leaves with its velocity alone. */
export const THROW_SPEED = 200
/** px/s, the most a chip keeps when it is let go. */
export const MAX_TOSS = 1800
