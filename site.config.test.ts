import { expect, test } from 'vitest'
import { publicAddress } from './site.config.mjs'

test('an edit link never shows the token with which a host fetches the repository', () => {
  for (const address of [
    'https://x-access-token:v1.5c3b@github.com/liten/gravity-stack',
    'https://github.com/liten/gravity-stack.git',
    'git@github.com:liten/gravity-stack.git',
    'https://github.com/liten/gravity-stack/',
  ])
    expect(publicAddress(address)).toBe('https://github.com/liten/gravity-stack')
  expect(publicAddress('')).toBe('')
})
