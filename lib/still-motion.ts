/** Whether the reader prefers reduced motion, as the system says now. */
export const stillMotion = () => matchMedia('(prefers-reduced-motion: reduce)').matches
