/** Three chips in a pile, as in `app/icon.svg`. */
export function Mark({ className }: { className?: string }) {
  return (
    <svg aria-hidden="true" viewBox="0 0 24 24" className={className}>
      <rect x="1" y="14.5" width="13" height="7" rx="3.5" fill="#f8694b" />
      <rect x="15" y="14.5" width="8" height="7" rx="3.5" fill="#4a9df0" />
      <rect x="7.5" y="4.4" width="14" height="7" rx="3.5" fill="#f0bf2b" transform="rotate(24 14.5 7.9)" />
    </svg>
  )
}
