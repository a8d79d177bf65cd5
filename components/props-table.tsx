import { readActions, readProps } from '@/lib/props'
import { typeset } from '@/lib/typeset'
import { ScrollTable } from './scroll-table'

/** JSDoc's words, with what stands in backticks as code. */
const withCode = (words: string) =>
  words.split('`').map((part, i) =>
    i % 2 === 0 ? (
      typeset(part)
    ) : (
      <code key={part} className="whitespace-nowrap">
        {part}
      </code>
    ),
  )

/** Generated from the JSDoc of `GravityStackProps` at build time. */
export function PropsTable() {
  return (
    <ScrollTable label="Props">
      <thead>
        <tr className="border-b text-muted-foreground">
          <th scope="col" className="px-3 py-2.5 sm:px-4 font-medium">
            Prop and type
          </th>
          <th scope="col" className="px-3 py-2.5 sm:px-4 font-medium max-sm:hidden">
            Default
          </th>
          <th scope="col" className="px-3 py-2.5 sm:px-4 font-medium">
            What it does
          </th>
        </tr>
      </thead>
      <tbody>
        {readProps().map((prop) => (
          <tr key={prop.name} id={`prop-${prop.name}`} className="border-b align-baseline last:border-0">
            <th scope="row" className="px-3 py-3 sm:px-4 font-medium font-mono text-[0.8125rem]">
              {prop.name}
              <span className="block break-words font-normal text-muted-foreground text-xs">
                <span className="sr-only">, </span>
                {prop.type.replace('<', '<\u200b')}
                {prop.range && `, ${prop.range}`}
                {prop.fallback && <span className="block sm:hidden">= {prop.fallback}</span>}
              </span>
            </th>
            <td className="px-3 py-3 sm:px-4 font-mono text-[0.8125rem] text-muted-foreground max-sm:hidden">
              {prop.fallback ?? '–'}
            </td>
            <td className="px-3 py-3 sm:px-4">{withCode(prop.description)}</td>
          </tr>
        ))}
      </tbody>
    </ScrollTable>
  )
}

/** Generated from the JSDoc of `GravityStackActions` at build time. */
export function ActionsTable() {
  return (
    <ScrollTable label="Actions">
      <thead>
        <tr className="border-b text-muted-foreground">
          <th scope="col" className="px-3 py-2.5 sm:px-4 font-medium">
            Action
          </th>
          <th scope="col" className="px-3 py-2.5 sm:px-4 font-medium">
            What it does
          </th>
        </tr>
      </thead>
      <tbody>
        {readActions().map((action) => (
          <tr
            key={action.name}
            id={`action-${action.name}`}
            className="border-b align-baseline last:border-0"
          >
            <th scope="row" className="px-3 py-3 sm:px-4 font-medium font-mono text-[0.8125rem]">
              {action.name}()
            </th>
            <td className="px-3 py-3 sm:px-4">{withCode(action.description)}</td>
          </tr>
        ))}
      </tbody>
    </ScrollTable>
  )
}
