import { cn } from 'cn'
import * as React from 'react'
import { createStage, type Stage } from './stage/stage'

/** What `actionsRef` gives a caller. */
export interface GravityStackActions {
  /** Drops all chips again and ends a pause; does nothing before the stage has first come into view. */
  drop: () => void
  /** Throws the chips about 230 px into the air at most; while paused, on `resume`. */
  shake: () => void
  /** Freezes the chips where they are. */
  pause: () => void
  /** Goes on after `pause`. */
  resume: () => void
}

/**
 * Numbers out of range are brought into it, and what is no number counts as left out; in development a warning says so.
 */
export interface GravityStackProps extends React.ComponentPropsWithoutRef<'div'> {
  /**
   * The objects that fall. Each child is one rigid body with the size and corner radius it is drawn with; one without
   * a size waits until it has one.
   */
  children?: React.ReactNode
  /**
   * Downward acceleration, px/s².
   * @default 2600
   */
  gravity?: number | undefined
  /**
   * Restitution: the share of its speed that a chip keeps when it bounces.
   * @default 0.18
   */
  bounce?: number | undefined
  /**
   * Average time between releases, in ms; each may come up to 120 ms late.
   * @default 150
   */
  stagger?: number | undefined
  /**
   * Lets people grab and toss the chips with a pointer.
   * @default true
   */
  interactive?: boolean | undefined
  /**
   * Starts each chip turned by so many half turns (a square one by quarters, a disc by any angle) that after an undisturbed drop its
   * words lie the right way up. The pile is the same with and without.
   * @default true
   */
  upright?: boolean | undefined
  /**
   * `false` leaves out the drop: the pile lies there as soon as it is known, and until then the chips stand in a row. For pages that
   * people come back to. Read once; `drop()` lets the chips fall all the same.
   * @default true
   */
  initial?: boolean | undefined
  /** Classes of the stage; they set its height, 20rem by default. */
  className?: string | undefined
  /**
   * Coulomb friction between chips, and of chips on floor and walls.
   * @default 0.4
   */
  friction?: number | undefined
  /** Called each time the last moving chip comes to rest; never with reduced motion, where nothing moves. */
  onSettle?: (() => void) | undefined
  /** Receives the stage's actions: `drop()`, `shake()`, `pause()`, `resume()`. */
  actionsRef?: React.Ref<GravityStackActions> | undefined
}

/** Stands for a text, or a portal, among elements: React then gives it a key by its slot among the children. */
const Words = ({ children }: { children: React.ReactNode }) => <>{children}</>

/** What React wraps a child in that has not come yet, such as an async server component; `_init` throws a promise until then. */
type Late = { _init?: (payload: unknown) => React.ReactNode; _payload: unknown }

/** Children without such wraps: `React.Children` takes them off from React 19 on, and throws at them before. */
function unwrapped(children: React.ReactNode): React.ReactNode {
  if (Array.isArray(children)) return children.map(unwrapped)
  const { _init, _payload } = Object(children) as Late
  return _init ? unwrapped(_init(_payload)) : children
}

/** The children as they fall, one by one with a key each: fragments and arrays are opened, nothings left out. */
function chipsOf(children: React.ReactNode, path = ''): [key: string, chip: React.ReactNode][] {
  const all: React.ReactNode[] | null | undefined = React.Children.map(unwrapped(children), (child) => {
    if (child === null || React.isValidElement(child)) return child
    // Blank text is what `{name && …}` leaves of an empty name, and what formatters put between two elements.
    return typeof child === 'object' || String(child).trim() ? <Words>{child}</Words> : null
  })
  return (all ?? []).flatMap((child): [string, React.ReactNode][] => {
    const { key: own, type, props } = child as React.ReactElement<React.PropsWithChildren>
    const key = `${path}/${own}`
    return type === React.Fragment
      ? chipsOf(props.children, key)
      : [[key, type === Words ? props.children : child]]
  })
}

// @refresh reset: in development an edit anywhere in this file drops the pile anew.

/**
 * A stage whose children drop in, tumble, bounce and settle into a pile that people can grab and toss.
 * In print, without script and for people who prefer reduced motion they stand in a row instead: that is CSS alone,
 * so the markup is the same everywhere.
 */
export const GravityStack: React.ForwardRefExoticComponent<
  GravityStackProps & React.RefAttributes<HTMLDivElement>
> = React.forwardRef(function GravityStack(
  {
    children,
    gravity,
    bounce,
    stagger,
    interactive = true,
    upright = true,
    initial = true,
    className,
    friction,
    onSettle,
    actionsRef,
    ...props
  }: GravityStackProps,
  ref: React.ForwardedRef<HTMLDivElement>,
) {
  const root = React.useRef<HTMLDivElement>(null)
  const stage = React.useRef<Stage | null>(null)
  const pausing = React.useRef(false)
  const [falls] = React.useState(initial)

  React.useEffect(() => {
    // A document without layout, as tests have it, has nothing to watch. What else it lacks they often mock; this nobody does.
    if (!window.CSSTransition) return
    // What React hides and shows again keeps its pile.
    if (!stage.current) stage.current = createStage(root.current!, pausing)
    stage.current.attach()
    return stage.current.detach
  }, [])

  React.useEffect(() => {
    stage.current?.setProps({
      gravity,
      bounce,
      friction,
      stagger,
      interactive,
      upright,
      initial: falls,
      onSettle,
    })
  })

  React.useImperativeHandle(ref, () => root.current!, [])
  React.useImperativeHandle(actionsRef, () => {
    const pause = (yes: boolean) => {
      pausing.current = yes
      stage.current?.update()
    }
    return {
      drop: () => stage.current?.drop(),
      shake: () => stage.current?.shake(),
      pause: () => pause(true),
      resume: () => pause(false),
    }
  }, [])

  return (
    <div
      {...props}
      ref={root}
      data-slot="gravity-stack"
      data-state="static"
      // The stage takes it away once the pile is there.
      data-row={falls ? undefined : ''}
      className={cn(
        'group/stack relative isolate flex h-80 w-full break-inside-avoid flex-wrap content-end items-end justify-center gap-2 contain-content',
        '[@media_print,(prefers-reduced-motion:reduce),(scripting:none)]:min-h-fit [@media_print,(prefers-reduced-motion:reduce),(scripting:none)]:p-4',
        '[@media_print,(prefers-reduced-motion:reduce),(scripting:none)]:overflow-visible [@media_print,(prefers-reduced-motion:reduce),(scripting:none)]:contain-none',
        // A stage with another overflow, by a caller's class, style or rule, would scroll to what has the focus.
        'not-print:not-data-[state=static]:overflow-clip!',
        // The whole stage, not the chips alone: a quick click that misses a chip would select words after the stage.
        interactive &&
          'select-none data-halted:select-auto [@media_print,(prefers-reduced-motion:reduce),(scripting:none)]:select-auto',
        !falls && 'data-row:p-4',
        className,
      )}
    >
      {chipsOf(children).map(([key, child]) => (
        <div
          key={key}
          data-slot="gravity-stack-chip"
          data-state="waiting"
          // What a translator or an extension puts into mere words is not what they are drawn on.
          data-words={typeof child === 'object' ? undefined : ''}
          // A browser that keeps the page in place by a chip, when something above grows, gives up as the chip moves.
          // No wider than its stage less a pixel: layout knows fractions of one, walls only whole ones, and a chip wedged between them never rests.
          // The CLI gives its prefix only to classes that stand here, and turns `left-0` round for pages that read from the right.
          className={cn(
            'absolute top-0 [left:0] m-0! flex w-max max-w-[calc(100%-1px)] [overflow-anchor:none] [transition:initial]! *:m-0! [:where(&_:is(dialog,[popover],:fullscreen,[contenteditable]:not([contenteditable=false]),[data-no-grab]))]:cursor-auto [:where(&_:is(dialog,[popover],:fullscreen,[contenteditable]:not([contenteditable=false]),[data-no-grab]))]:select-text',
            // Until its release it stands unseen in the stage, at its top, so that focus, find, a link to it or to its text leads
            // there. Clipped to nothing, as what is transparent is still pressed, and slows Chromium down by its layers.
            '[&:where([data-state=waiting])]:[clip-path:inset(50%)]',
            'data-[state=held]:will-change-transform data-[state=falling]:will-change-transform group-data-halted/stack:will-change-auto!',
            'forced-colors:*:not-focus-visible:outline forced-colors:*:not-focus-visible:-outline-offset-1',
            'forced-colors:not-has-[*]:outline forced-colors:not-has-[*]:-outline-offset-1',
            '[@media_print,(prefers-reduced-motion:reduce),(scripting:none)]:relative [@media_print,(prefers-reduced-motion:reduce),(scripting:none)]:transform-none! [@media_print,(prefers-reduced-motion:reduce),(scripting:none)]:[clip-path:none]! [@media_print,(prefers-reduced-motion:reduce),(scripting:none)]:[--chip-angle:0deg]!',
            !falls &&
              'group-data-row/stack:relative group-data-row/stack:transform-none! group-data-row/stack:[clip-path:none]!',
            interactive &&
              'cursor-grab touch-pan-y touch-pinch-zoom group-data-halted/stack:cursor-auto group-data-halted/stack:touch-auto data-[state=held]:cursor-grabbing [@media_print,(prefers-reduced-motion:reduce),(scripting:none)]:cursor-auto [@media_print,(prefers-reduced-motion:reduce),(scripting:none)]:touch-auto',
          )}
        >
          {/* An element alone would be asked for no key, in a list that has none. Words alone React writes anew after a translator. */}
          {typeof child === 'object' ? [child] : child}
        </div>
      ))}
    </div>
  )
})
