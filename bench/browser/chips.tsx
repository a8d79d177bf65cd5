import type * as React from 'react'

const WORDS =
  'design tokens motion springs layout colour type grid focus contrast states icons voice scale rhythm depth'.split(
    ' ',
  )
const TINTS = ['bg-amber-200', 'bg-emerald-200', 'bg-sky-200', 'bg-rose-200', 'bg-violet-200']

/** The same pills for every stage. */
export const pills = (count: number) =>
  Array.from({ length: count }, (_, i) => i).map((i) => ({
    key: i,
    pill: (
      <span
        key={i}
        className={`block rounded-full px-3 py-1 text-neutral-900 text-xs ${TINTS[i % TINTS.length]}`}
      >
        {WORDS[i % WORDS.length]}
      </span>
    ),
  }))

export interface StageProps {
  chips: number
  /** ms between releases. */
  stagger: number
  /** px */
  width: number
  height: number
  /** Never lets the pile rest. */
  restless: boolean
  /** Plans the drop so that words end the right way up, where a stage can. */
  upright: boolean
}

/** What a stage without a component of its own starts from: chips above a box, for a script to move. */
export function Field({
  ref,
  chips,
  ...size
}: { ref: React.Ref<HTMLDivElement> } & Pick<StageProps, 'chips' | 'width' | 'height'>) {
  return (
    <div ref={ref} className="relative overflow-hidden bg-neutral-100" style={size}>
      {pills(chips).map(({ key, pill }) => (
        <div
          key={key}
          data-slot="gravity-stack-chip"
          className="absolute top-0 left-0 w-max will-change-transform"
          style={{ transform: 'translateY(-200px)' }}
        >
          {pill}
        </div>
      ))}
    </div>
  )
}
