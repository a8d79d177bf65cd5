'use client'

import dynamic from 'next/dynamic'

/** An example of the registry by its name. Pages without one don't bring them, nor the component. */
export const Demo = dynamic(() => import('./demos').then((file) => file.Demo))
