import type { CSSProperties } from 'react'
import { chipColours } from '@/components/lab/draw'
import { type LyingChip, uprightPile, uprightStage } from '@/lib/upright-pile'

/**
 * One pile twice: as chips fall, and as the component shows it. The solver has left it so when the site was
 * built; the page flips it by CSS alone.
 */
export function UprightFlip() {
  const { pile, upsideDown } = uprightPile()
  const { width, height } = uprightStage
  const top = Math.min(...pile.map(({ y }) => y)) - 64
  const ways = [
    { value: 'now', label: 'The right way up', says: `0 of ${pile.length} words upside down` },
    { value: 'before', label: 'As chips fall', says: `${upsideDown} of ${pile.length} words upside down` },
  ]
  return (
    <fieldset className="group/flip overflow-hidden rounded-2xl border bg-panel has-[[value=before]:checked]:[--upright:0] [--upright:1]">
      <legend className="sr-only">How the words of a pile lie</legend>
      <svg
        viewBox={`0 ${top} ${width} ${height - top}`}
        role="img"
        aria-label={`A pile of ${pile.length} chips. As they fall, ${upsideDown} words are upside down. Turned by the look-ahead, none is, and every outline lies where it lay.`}
        className="block w-full border-b bg-stage"
      >
        {pile.map((chip, i) => (
          <Chip key={chip.word} chip={chip} fill={chipColours[i % chipColours.length]} />
        ))}
      </svg>
      <div className="flex flex-wrap items-center justify-between gap-x-6 gap-y-2 p-3 text-sm">
        <div className="flex gap-1 rounded-lg bg-muted p-1">
          {ways.map(({ value, label }) => (
            <label
              key={value}
              className="cursor-pointer rounded-md px-3 py-1.5 text-muted-foreground has-checked:bg-background has-checked:text-foreground has-checked:shadow-sm has-focus-visible:outline-2 has-focus-visible:outline-offset-2"
            >
              <input
                type="radio"
                name="upright"
                value={value}
                defaultChecked={value === 'now'}
                className="sr-only"
              />
              {label}
            </label>
          ))}
        </div>
        <p className="px-1 text-muted-foreground tabular-nums">
          <span className="group-has-[[value=before]:checked]/flip:hidden">{ways[0].says}</span>
          <span className="hidden group-has-[[value=before]:checked]/flip:inline">{ways[1].says}</span>
        </p>
      </div>
    </fieldset>
  )
}

function Chip({ chip, fill }: { chip: LyingChip; fill: string }) {
  const { word, width, height, radius, x, y, angle, turn } = chip
  const style = { '--angle': `${angle}rad`, '--turn': `${turn}rad` } as CSSProperties
  return (
    <g transform={`translate(${x} ${y})`}>
      <g
        style={style}
        className="rotate-[calc(var(--angle)+var(--upright)*var(--turn))] transition-[rotate] duration-700 ease-in-out motion-reduce:transition-none"
      >
        <rect x={-width / 2} y={-height / 2} width={width} height={height} rx={radius} fill={fill} />
        <text
          textAnchor="middle"
          dominantBaseline="central"
          className="fill-stone-900 font-medium text-[13px]"
        >
          {word}
        </text>
      </g>
    </g>
  )
}
