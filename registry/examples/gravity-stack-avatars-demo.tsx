import { GravityStack } from '@/components/ui/gravity-stack'

const people: [name: string, colours: string, size: string][] = [
  ['Ada Okafor', 'bg-rose-300 text-rose-950', 'size-20 text-2xl'],
  ['Bo Lindqvist', 'bg-sky-300 text-sky-950', 'size-12'],
  ['Chen Wei', 'bg-amber-300 text-amber-950', 'size-14 text-lg'],
  ['Dina Haddad', 'bg-emerald-300 text-emerald-950', 'size-16 text-xl'],
  ['Emil Novák', 'bg-violet-300 text-violet-950', 'size-12'],
  ['Fatou Diop', 'bg-orange-300 text-orange-950', 'size-14 text-lg'],
  ['Gil Moreno', 'bg-cyan-300 text-cyan-950', 'size-20 text-2xl'],
  ['Hana Sato', 'bg-pink-300 text-pink-950', 'size-12'],
  ['Ines Rocha', 'bg-lime-300 text-lime-950', 'size-16 text-xl'],
  ['Jonas Weber', 'bg-indigo-300 text-indigo-950', 'size-14 text-lg'],
  ['Kavya Rao', 'bg-teal-300 text-teal-950', 'size-12'],
]

const initials = (name: string) => name.replace(/(\S)\S*\s*/g, '$1')

/** A child that is as wide as it is high and `rounded-full` is a disc, and rolls like one. */
export function GravityStackAvatarsDemo() {
  return (
    <GravityStack className="h-80" bounce={0.4} friction={0.6}>
      {people.map(([name, colours, size]) => (
        <span
          key={name}
          role="img"
          aria-label={name}
          className={`grid place-items-center rounded-full font-semibold text-base ${colours} ${size}`}
        >
          {initials(name)}
        </span>
      ))}
    </GravityStack>
  )
}
