/** Three chips in a pile. */
export function Mark({ className }: { className?: string }) {
  return (
    <svg aria-hidden="true" viewBox="0 0 24 24" className={className}>
      <rect x="1.5" y="16" width="12" height="6" rx="3" fill="oklch(0.7 0.19 35)" />
      <rect x="15" y="16" width="7.5" height="6" rx="3" fill="oklch(0.68 0.15 250)" />
      <rect
        x="8.2"
        y="6.6"
        width="12.5"
        height="6"
        rx="3"
        fill="oklch(0.83 0.17 90)"
        transform="rotate(24 14.5 9.6)"
      />
    </svg>
  )
}
