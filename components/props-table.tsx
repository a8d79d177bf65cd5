import { readActions, readProps } from '@/lib/props'
import { ScrollTable } from './scroll-table'

/** Generated from the JSDoc of `GravityStackProps` at build time. */
export function PropsTable() {
  return (
    <ScrollTable label="Props">
      <thead>
        <tr className="border-b text-muted-foreground">
          <th scope="col" className="px-4 py-2.5 font-medium">
            Prop
          </th>
          <th scope="col" className="px-4 py-2.5 font-medium">
            Type
          </th>
          <th scope="col" className="px-4 py-2.5 font-medium">
            Default
          </th>
          <th scope="col" className="px-4 py-2.5 font-medium">
            What it does
          </th>
        </tr>
      </thead>
      <tbody>
        {readProps().map((prop) => (
          <tr key={prop.name} className="border-b align-baseline last:border-0">
            <th scope="row" className="px-4 py-3 font-medium font-mono text-[0.8125rem]">
              {prop.name}
            </th>
            <td className="px-4 py-3 font-mono text-[0.8125rem] text-muted-foreground">{prop.type}</td>
            <td className="px-4 py-3 font-mono text-[0.8125rem] text-muted-foreground">
              {prop.fallback ?? '–'}
            </td>
            <td className="min-w-56 px-4 py-3">{prop.description}</td>
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
          <th scope="col" className="px-4 py-2.5 font-medium">
            Action
          </th>
          <th scope="col" className="px-4 py-2.5 font-medium">
            What it does
          </th>
        </tr>
      </thead>
      <tbody>
        {readActions().map((action) => (
          <tr key={action.name} className="border-b align-baseline last:border-0">
            <th scope="row" className="px-4 py-3 font-medium font-mono text-[0.8125rem]">
              {action.name}()
            </th>
            <td className="px-4 py-3">{action.description}</td>
          </tr>
        ))}
      </tbody>
    </ScrollTable>
  )
}
