/** What `npm run bench:browser` writes and the page of the benchmarks shows. */
export type StageName = 'gravity-stack' | 'circle-chains' | 'matter-js'

/** ms a frame on the main thread. */
export type FrameCost = { median: number; p99: number; worst: number }

/**
 * A drop from its first frame until all lie still, or for the given time: each number is the median of three.
 */
export type Drop = {
  chips: number
  /** ms between releases. */
  stagger: number
  /** Times that the processor was slowed down. */
  throttle: number
  seconds: number
  frames: number
  /** Frames a second. */
  rate: number
  script: FrameCost
  /** Style and layout, then pre-paint, paint and handing over to the compositor. */
  style: FrameCost
  paint: FrameCost
  /** ms a frame of all raster threads together, and of putting the layers together on the screen. */
  raster: number
  compositor: number
  /** Most layouts or recalculated styles inside script in any of them. */
  forced: number
  /** ms of the longest collection of garbage, and how many there were. */
  garbage: { longest: number; count: number }
}

/**
 * By throttle, medians: ms of the processor for script of a drop of 60 chips from view to rest, with the plan
 * and without, and for the plan's longest slice.
 */
export type PlanCost = {
  commit: string
  costs: Record<string, { planned: number; plain: number; slice: number }>
}

export type StageResult = {
  /** Bytes of its script, minified and compressed, all but React and `cn`. */
  bytes: number
  drops: Drop[]
  /** Frames a second of a thousand chips drawn as in the drop, without physics; the median of three. */
  replay?: number
  /** Of a stage that plans how its chips will lie. */
  plan?: PlanCost
  /**
   * By throttle: ms of script, style and layout from view to first frame of 60 chips; the median of five
   * pages.
   */
  firstDrop: Record<string, number>
  /** Layouts from the server's markup to the first frame, 60 chips. */
  mountLayouts: number
  /** Sum of layout shifts from load to the last frame. */
  shift: number
  /** Most layers of chips during the drop, and those left afterwards. */
  layers: { most: number; after: number }
  /** Writes to chips' styles a frame while they fall; frames and writes in the second after the drop. */
  writes: { perFrame: number; after: number; framesAfter: number }
  /**
   * By throttle: ms of the slowest interaction while 60 chips settle; the median of three pages. Browsers
   * report 16 at least.
   */
  interaction: Record<string, number>
  /**
   * 30 s of 60 chips at work, after 30 s of the same, in bytes: allocated a frame, growth of what is kept,
   * and the heap in each second.
   */
  heap: { perFrame: number; growth: number; samples: number[] }
}

export type BrowserResults = {
  date: string
  commit: string
  machine: {
    cpu: string
    cores: number
    memoryGB: number
    system: string
    node: string
    browser: string
  }
  versions: Partial<Record<StageName, string>>
  /** Script of a page whose frame loop does nothing, by throttle: what no stage can go below. */
  idle: Record<string, FrameCost>
  stages: Record<StageName, StageResult>
}
