import { cn } from 'cn'
import * as React from 'react'
import { createStage, type Stage } from './stage/stage'

/** The actions that `actionsRef` gives to a caller. */
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

/** A number out of range is clamped, and a value that is no number counts as left out, with a warning. */
export interface GravityStackProps extends React.ComponentPropsWithoutRef<'div'> {
  /**
   * The objects that fall. Each child is one rigid body with the size and corner radius it is drawn with. A
   * child without a size waits until it has one.
   */
  children?: React.ReactNode
  /**
   * Acceleration in px/s². A number points down. `{ x, y }` points to the right and down, with minus signs to
   * the left and up. Chips always come in from above.
   * @default 2600
   */
  gravity?: number | { x: number; y: number } | undefined
  /**
   * Closes the top for what has come in. Gravity that points up closes it by itself.
   * @default false
   */
  ceiling?: boolean | undefined
  /**
   * Radius in px of a disc that goes with a mouse or a pen over the stage and shoves chips aside. It needs
   * `interactive`.
   * @default 0
   */
  push?: number | undefined
  /**
   * Refs of elements elsewhere on the page. Chips land on these where they lie over or under the stage.
   * Children with the attribute `data-static` are obstacles too, and stay where their own CSS puts them.
   */
  obstacles?: { readonly current: Element | null } | { readonly current: Element | null }[] | undefined
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
   * Lets people grab, toss, tap and push the chips with a pointer.
   * @default true
   */
  interactive?: boolean | undefined
  /**
   * Words lie the right way up after a drop that nobody disturbs. For that a chip may be drawn turned: by
   * half a turn, a square by quarters, a disc by any angle. The pile is the same with and without.
   * @default true
   */
  upright?: boolean | undefined
  /**
   * `false` leaves out the first drop, for pages that people come back to. The chips stand in a row until
   * their pile is computed, and then lie in it. Read once; `drop()` still lets the chips fall.
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
  /** Receives the actions of the stage: `drop()`, `shake()`, `pause()`, `resume()`. */
  actionsRef?: React.Ref<GravityStackActions> | undefined
}

/** Marks a text or a portal, so that React gives it a key by its place among the children; never rendered. */
const Words: React.FC<{ children: React.ReactNode }> = () => null

/** React's wrapper of a child that is still loading: `_init` throws a promise until it has arrived. */
type Late = { _init?: (payload: unknown) => React.ReactNode; _payload: unknown }

/** Opens wrapped children. `React.Children` does so from React 19 on; that of React 18 throws at them. */
function unwrapped(children: React.ReactNode): React.ReactNode {
  if (Array.isArray(children)) return children.map(unwrapped)
  const { _init, _payload } = Object(children) as Late
  return _init ? unwrapped(_init(_payload)) : children
}

/** The children that fall, each with a key. Fragments and arrays are opened, empty children left out. */
function chipsOf(children: React.ReactNode, path = ''): [key: string, chip: React.ReactNode][] {
  const all: React.ReactNode[] | null | undefined = React.Children.map(unwrapped(children), (child) => {
    if (child === null || React.isValidElement(child)) return child
    // Blank text comes from `{name && …}` with an empty name, and from formatters between two elements.
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

/** Whether a child stays where its own CSS puts it. */
function isObstacle(child: React.ReactNode) {
  return (Object(child).props?.['data-static'] ?? false) !== false
}

// @refresh reset: in development, an edit anywhere in this file drops the chips again.

/**
 * A stage whose children drop in, tumble, bounce and settle into a pile that people can grab and toss. In
 * print, without script and with reduced motion the chips stand in a row instead. CSS alone does that, so the
 * markup is the same everywhere.
 */
export const GravityStack: React.ForwardRefExoticComponent<
  GravityStackProps & React.RefAttributes<HTMLDivElement>
> = React.forwardRef(function GravityStack(
  {
    children,
    gravity,
    ceiling = false,
    push,
    obstacles,
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
    // A document without layout, as in unit tests, has nothing to watch. Tests often mock the observers, but
    // never this class.
    if (!window.CSSTransition) return
    // A stage that React hides and shows again keeps its pile.
    if (!stage.current) stage.current = createStage(root.current!, pausing)
    stage.current.attach()
    return stage.current.detach
  }, [])

  React.useEffect(() => {
    stage.current?.setProps({
      gravity,
      ceiling,
      push,
      obstacles,
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
      // The stage removes this attribute once the pile is computed.
      data-row={falls ? undefined : ''}
      className={cn(
        'group/stack relative isolate flex h-80 w-full break-inside-avoid flex-wrap content-end items-end justify-center gap-2 contain-content',
        '[@media_print,(prefers-reduced-motion:reduce),(scripting:none)]:min-h-fit [@media_print,(prefers-reduced-motion:reduce),(scripting:none)]:p-4',
        '[@media_print,(prefers-reduced-motion:reduce),(scripting:none)]:overflow-visible [@media_print,(prefers-reduced-motion:reduce),(scripting:none)]:contain-none',
        // With another overflow, from a class, style or rule of the caller, the stage would scroll to a chip
        // with the focus.
        'not-print:not-data-[state=static]:overflow-clip!',
        // No text can be selected in the stage: a quick click beside a chip would select words after it.
        interactive &&
          'select-none data-halted:select-auto [@media_print,(prefers-reduced-motion:reduce),(scripting:none)]:select-auto',
        !falls && 'data-row:p-4',
        className,
      )}
    >
      {chipsOf(children).map(([key, child]) =>
        isObstacle(child) ? (
          <React.Fragment key={key}>{child}</React.Fragment>
        ) : (
          <div
            key={key}
            data-slot="gravity-stack-chip"
            data-state="waiting"
            // Elements that a translator or an extension puts into mere words don't give the chip its shape.
            data-words={typeof child === 'object' ? undefined : ''}
            // Chips are no scroll anchors: a browser that anchors to a moving chip would scroll the page. A
            // chip is a pixel narrower than its stage: layout has fractions of a pixel, walls only whole
            // ones, and a chip that is wedged between them never rests. The shadcn CLI adds its prefix only
            // to classes inside `className`, and mirrors `left-0` for right-to-left pages.
            className={cn(
              'absolute top-0 [left:0] m-0! flex w-max max-w-[calc(100%-1px)] [overflow-anchor:none] [transition:initial]! *:m-0! [:where(&_:is(dialog,[popover],:fullscreen,[contenteditable]:not([contenteditable=false]),[data-no-grab]))]:cursor-auto [:where(&_:is(dialog,[popover],:fullscreen,[contenteditable]:not([contenteditable=false]),[data-no-grab]))]:select-text',
              // A chip that waits stands unseen at the top of the stage, so that focus, find and links lead
              // there. It is clipped to nothing: a transparent chip would still take presses, and its layer
              // would slow Chromium down.
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
            {/* React asks elements of an array for keys. Words alone are rendered anew after translation. */}
            {typeof child === 'object' ? [child] : child}
          </div>
        ),
      )}
    </div>
  )
})
