import type { ComponentProps } from 'react'

type Props = ComponentProps<'h2'> & { as: 'h2' | 'h3' }

/** A heading whose words are a link to itself. */
export function Heading({ as: Tag, id, className = '', children }: Props) {
  return (
    <Tag id={id} className={`group ${className}`}>
      <a data-plain href={`#${id}`}>
        {children}
        <span aria-hidden="true" className="ml-2 text-muted-foreground opacity-0 group-hover:opacity-100">
          #
        </span>
      </a>
    </Tag>
  )
}
