/**
 * Every record of the solver, and no behaviour. Bodies and contacts live in flat arrays, one record each; a
 * name in capitals is the place of a field in its record, so that `state[i * STATE + VX]` is a velocity of
 * body `i`.
 */

/**
 * Mask for indices read from a list. It changes none, but tells the compiler that offsets computed from one
 * can't overflow, which saves it a check at every access.
 */
export const INDEX = 0xffffff

/**
 * Body 0 is the floor, 1 and 2 are the left and right wall, 3 is the ceiling, 4 the disc of a push, which
 * collides with nothing in a step. Chips and obstacles begin at 5.
 */
export const CEILING = 3
export const PUSHER = 4
export const FIRST_CHIP = 5

// Record of `state`, read by every iteration: one cache line a body.
export const X = 0
export const Y = 1
export const ANGLE = 2
export const VX = 3
export const VY = 4
export const SPIN = 5
export const INV_MASS = 6
export const INV_INERTIA = 7
export const STATE = 8

// Record of `motion`, read once a sub-step.
/** Warm start: change of velocity that the contacts gave in the last sub-step. */
export const WARM_X = 0
export const WARM_Y = 1
export const WARM_SPIN = 2
/** Velocity after gravity, drag and warm start, which the contact solver begins with. */
export const START_X = 3
export const START_Y = 4
export const START_SPIN = 5
/** Displacement of the sub-step without what the contact solver adds. */
export const DELTA_X = 6
export const DELTA_Y = 7
export const DELTA_ANGLE = 8
/** Rotation as a unit vector, and the angle that it stands for. */
export const COS = 9
export const SIN = 10
export const ROTATED_TO = 11
/** Change of spin by rolling resistance in a sub-step. */
export const ROLLING_IMPULSE = 12
/** s from the start of the sub-step at which the body was last struck in it. */
export const STRUCK_AT = 13
/**
 * px that the farthest point of the core has travelled, and where that count may stand after the coming
 * sub-step.
 */
export const TRAVEL = 14
export const HORIZON = 15
/** Pose up to which the travel is counted. */
export const SEEN_X = 16
export const SEEN_Y = 17
export const SEEN_ANGLE = 18
export const MOTION = 19

// Record of `shape`: a core rectangle swept by a radius, which is disc, pill, rounded box and box in one
// family.
/** px, half extents of the core. */
export const HX = 0
export const HY = 1
export const RADIUS = 2
/** px from the centre to the farthest point of the outline, and of the core. */
export const EXTENT = 3
export const CORE = 4
export const SHAPE = 5

/**
 * Records of the solver are classes. V8 forgets the shape of an object literal when a second one is made, and
 * throws away what was compiled for the first.
 */
export class Bodies {
  /** Slots in use, walls included; the slot of a removed body counts until it is used again. */
  count = FIRST_CHIP
  state: Float64Array = new Float64Array(FIRST_CHIP * STATE)
  motion: Float64Array = new Float64Array(FIRST_CHIP * MOTION)
  shape: Float64Array = new Float64Array(FIRST_CHIP * SHAPE)
  /** Pose at the start of the step (x, y, angle), for drawing between steps. */
  before: Float64Array = new Float64Array(FIRST_CHIP * 3)
  /** Pose that rest is measured against (x, y, angle), and s that it has held, half of them if balanced. */
  rest: Float64Array = new Float64Array(FIRST_CHIP * 4)
  /** Mass per px². */
  density: Float64Array = new Float64Array(FIRST_CHIP)
  /** 1 while the slot holds a body. */
  alive: Uint8Array = new Uint8Array(FIRST_CHIP)
  asleep: Uint8Array = new Uint8Array(FIRST_CHIP)
  /** 1 if the body moved noticeably since the last sub-step. */
  moved: Uint8Array = new Uint8Array(FIRST_CHIP)
  /** 1 while position correction may not move the body. */
  immovable: Uint8Array = new Uint8Array(FIRST_CHIP)
  /** 1 if the body was lifted out of a wedge, or pushed up by one below it that was. */
  lifted: Uint8Array = new Uint8Array(FIRST_CHIP)
  /** 1 while the body is awake, and until it is drawn once after it fell asleep. */
  needsDrawing: Uint8Array = new Uint8Array(FIRST_CHIP)
  /** 1 if the body has a better support, as its step begins, than one point that it is balanced on. */
  supported: Uint8Array = new Uint8Array(FIRST_CHIP)
  /** 1 once the body has wholly come into the stage: the ceiling is there for such bodies only. */
  inside: Uint8Array = new Uint8Array(FIRST_CHIP)
  /** Mouse joints that hold the body. */
  held: Uint8Array = new Uint8Array(FIRST_CHIP)
  awake: Int32Array = new Int32Array(FIRST_CHIP)
  awakeCount = 0
  /**
   * Turn of the contact solver in which the body's velocity last changed by more than the tolerance, or turn
   * of the position correction that last moved it out of a deep overlap.
   */
  changed: Int32Array = new Int32Array(FIRST_CHIP)
  /**
   * Parent of each body in the forest of groups that fall asleep together, and the shortest rest of a root's
   * group, s.
   */
  parent: Int32Array = new Int32Array(FIRST_CHIP)
  groupRest: Float64Array = new Float64Array(FIRST_CHIP)
  /** Left, top, right, bottom of each body's enlarged box, px. */
  box: Float64Array = new Float64Array(FIRST_CHIP * 4)
  /** 1 if the body has left its box, and has a new one. */
  leftBox: Uint8Array = new Uint8Array(FIRST_CHIP)
  /** 1 if the box has to be checked: at the start of a step, and after a knock. */
  knocked: Uint8Array = new Uint8Array(FIRST_CHIP)
  /** Bodies by the left edge of their box. */
  order: Int32Array = new Int32Array(FIRST_CHIP)
  orderCount = 0
  /** Those of them that have left their box. */
  leaving: Int32Array = new Int32Array(FIRST_CHIP)
  /** Body that last marked this one as a partner in a contact. */
  partner: Int32Array = new Int32Array(FIRST_CHIP)
}

// Record of `data`, one manifold. Arms are torques of a unit impulse along the normal (N) or the tangent (T).
/**
 * px, separation when it was measured, or a lower bound of it; relative position and both angles at that
 * time.
 */
export const SEPARATION = 0
export const FROM_X = 1
export const FROM_Y = 2
export const FROM_A = 3
export const FROM_B = 4
export const NORMAL_X = 5
export const NORMAL_Y = 6
/** Fields of point 1; those of point 2 lie `SECOND` places on and are zero without one. */
export const ARM_NA = 7
export const ARM_NB = 8
/** Accumulated impulse of a sub-step along the normal. */
export const NORMAL_IMPULSE = 9
/** px/s by which the gap may close in the sub-step; for an impact, minus the velocity that it leaves with. */
export const VELOCITY_BIAS = 10
/** Inverse effective mass along the normal. */
export const NORMAL_K = 11
/** px, separation at the origin of all poses. */
export const BASE_SEPARATION = 12
/** Which corner made the point. */
export const FEATURE_ID = 13
export const SECOND = 7
/** Coupling of the two points, and 1 / det K, 0 where the two are nearly one. */
export const COUPLING_K = 21
export const INV_DET = 22
/** Friction acts at one place: points that carry a load lie on one line along the tangent. */
export const ARM_TA = 23
export const ARM_TB = 24
export const TANGENT_IMPULSE = 25
export const TANGENT_MASS = 26
/** rad/s that the warm start of a wall gives body B beyond what its arms say: half of what they changed. */
export const ARM_LAG = 27
/** px/s of slip that friction aims at; other than 0 during an impact only. */
export const TANGENT_BIAS = 28
/** Steps in a row that left this contact in a deep overlap. One that left none so is not counted. */
export const DEEP_STEPS = 29
export const CONTACT = 30

/**
 * Contacts: pairs of bodies that may touch. A contact keeps its slot and its impulses for as long as the two
 * stay near. Between two measurements a separation is linear in the poses: base + n·(x_B − x_A) + arm_B·θ_B −
 * arm_A·θ_A.
 */
export class Contacts {
  /** Slots ever used; free ones among them are chained through `next`. */
  count = 0
  free = -1
  /** Body A and body B of each slot: A is static or the lower, B is never static, and 0 for a free slot. */
  pair: Int32Array = new Int32Array(8)
  data: Float64Array = new Float64Array(4 * CONTACT)
  /** Points of the manifold, 0 to 2. */
  points: Uint8Array = new Uint8Array(4)
  /** px. The record serves while the travel of both bodies together is below this; −∞ forces a check. */
  due: Float64Array = new Float64Array(4)
  /** Lists of the contacts of each chip: edge 2c is contact c seen from A, 2c + 1 from B; -1 ends a list. */
  head: Int32Array = new Int32Array(FIRST_CHIP).fill(-1)
  next: Int32Array = new Int32Array(8)
  /** Contacts between what is awake, and those of them that touch in the present sub-step. */
  near: Int32Array = new Int32Array(4)
  nearCount = 0
  live: Int32Array = new Int32Array(4)
  liveCount = 0
  /**
   * Impacts of a sub-step by time (s from its start), and the first that is still to come. Any may be queued
   * again.
   */
  queue: Int32Array = new Int32Array(16)
  queueTime: Float64Array = new Float64Array(16)
  queueCount = 0
  queueFirst = 0
}

/** A soft point constraint from a point of a body to the pointer. */
export interface MouseJoint {
  body: number
  /** px, the grabbed point in the body's own axes. */
  localX: number
  localY: number
  /** px, where the pointer is. */
  x: number
  y: number
  /** px, the place nearest to the pointer that the grabbed point can reach within walls and floor. */
  targetX: number
  targetY: number
  /** Where the pointer was lately, and s of simulated time since it last moved. */
  samples: { x: number; y: number; seconds: number }[]
  idle: number
  /** Accumulated impulse of a sub-step, and the arm (px) at which it acts. */
  impulseX: number
  impulseY: number
  armX: number
  armY: number
}

/** Closed form of v' = g − c·v over a time: v ← fade·v + g·reach, x ← x + reach·v + g·fall. */
export interface Damping {
  fade: number
  reach: number
  fall: number
}

/** Fields of `work`, what was done so far: for tests and tools, which set it back to 0 as they like. */
export const SUBSTEPS_TAKEN = 0
export const ITERATIONS_TAKEN = 1
export const CONTACTS_VISITED = 2
export const IMPACTS_SOLVED = 3
export const MANIFOLDS_MADE = 4

/** How exactly a step is solved. */
export class Regime {
  /** px/s, change of a velocity that the iterations leave alone. */
  tolerance = 0.5
  /** SOR factor. */
  relaxation = 0.5

  /** Ratio of the heaviest mass to the lightest. */
  massRatio = 0.5
  /** Whether nothing is fast. */
  resting = false
}

/**
 * All that a step works on. Fields that may hold fractions begin as fractions: to become one later would cost
 * the compiled code.
 */
export class Simulation {
  /**
   * Once all of a class have gone V8 forgets its shape, and throws away what was compiled for it: one stays.
   */
  static kept: Simulation = new Simulation()
  bodies = new Bodies()
  contacts = new Contacts()
  joints: MouseJoint[] = []
  regime = new Regime()
  /** Regime of a single impact. */
  impactRegime = new Regime()
  /** px, size of the stage. */
  width = 0.5
  height = 0.5
  /** px/s², to the right and downwards, and the length of the two. */
  gravity: Float64Array = new Float64Array(2)
  pull = 0.5
  /** Whether the top is closed. */
  ceiling = false
  bounce = 0.5
  friction = 0.5
  /** px/s of approach below which nothing bounces. */
  threshold = 0.5
  sleeps = true
  /** Sub-steps of a step, and the length of one, s. */
  substeps = 1
  h = 0.5
  /** What the air does to velocity and to spin in a sub-step. */
  air: Damping = { fade: 0.5, reach: 0.5, fall: 0.5 }
  spinAir: Damping = this.air
  /** Steps left in which room is made where moved walls, grown chips or obstacles press chips together. */
  roomSteps = 0

  /** s, time handed in and not simulated yet. */
  left = 0.5
  /** Ids of removed bodies, which the next bodies get. */
  freeSlots: number[] = []
  /** How often the world was changed from outside, other than by a new chip. */
  revision = 0
  work: Float64Array = new Float64Array(5)
}
