import 'server-only'
import { parse } from 'react-docgen'
import { componentFile, componentSource } from './source'

type Prop = { name: string; type: string; range?: string; fallback?: string; description: string }

/**
 * The rows of the props table, from the JSDoc of `GravityStackProps`. Throws, and so fails the build, when a
 * prop has no words or when its `@default` is not the one in the code.
 */
export function readProps(): Prop[] {
  const source = componentSource()
  const component = parse(source, { filename: componentFile }).find(
    (found) => found.displayName === 'GravityStack',
  )
  if (!component?.props) throw new Error(`${componentFile} exports no GravityStack with typed props`)

  return Object.entries(component.props).map(([name, prop]) => {
    const [description, written] = (prop.description ?? '').split(/^@default\s+/m).map((part) => part.trim())
    // Defaults of numbers stand in the table of limits, most of them by name, before the largest value.
    const [, usual, most] = source.match(new RegExp(`^  ${name}: \\[(\\w+), (\\d+)\\]`, 'm')) ?? []
    const inCode = prop.defaultValue?.value ?? usual
    const used = source.match(new RegExp(`^const ${inCode} = (.+)$`, 'm'))?.[1] ?? inCode
    if (!description) throw new Error(`GravityStackProps.${name} has no description`)
    if (used !== undefined && written !== used) {
      throw new Error(`GravityStackProps.${name} says @default ${written}, the code says ${used}`)
    }
    const raw = prop.tsType && 'raw' in prop.tsType && prop.tsType.raw ? prop.tsType.raw : prop.tsType?.name
    // That a prop may be left out says its question mark, for those who write it down as well.
    const type = raw?.replace(/ \| undefined$/, '').replace(/^\((.*)\)$/, '$1')
    const limit = most && Number(most).toLocaleString('en')
    return {
      name,
      type: type ?? 'unknown',
      range:
        limit && `0 to ${limit}${type?.includes('{ x') ? `, or x and y each −${limit} to ${limit}` : ''}`,
      fallback: written,
      description: description.replace(/\s*\n\s*/g, ' '),
    }
  })
}

/** The actions that `actionsRef` hands out, from the JSDoc of `GravityStackActions`. */
export function readActions(): { name: string; description: string }[] {
  const body = componentSource().match(/export interface GravityStackActions \{\n([\s\S]*?)\n\}/)?.[1]
  const actions = [...(body ?? '').matchAll(/\/\*\* (.+?) \*\/\s+(\w+): \(\) => void/g)]
  if (actions.length === 0) throw new Error(`${componentFile} exports no documented GravityStackActions`)
  return actions.map(([, description, name]) => ({ name, description }))
}
