"""Independent truths: what the Fourier-Taylor series are checked against.

Nothing here uses the solver, the series or the problems of `ftseries`, only its errors; the modules
rest on mpmath, SciPy and python-flint. Each also contains two routes that check each other:

- `cubic`: the oscillator (C1)-(C9) by Jacobi's elliptic functions; the period also by quadrature.
- `weierstrass`: the same motion as (C12), ℘ by theta functions of its invariants alone.
- `cubic_taylor`: exact Taylor coefficients in λ of the closed forms, from hypergeometric series.
- `mathieu`: the Hill equation (M1) by its truncated matrix, by Runge-Kutta integration, and at
  μ = 0 by SciPy's Mathieu functions.
- `three_bodies`: Newton's equations (E0), integrated by Runge-Kutta and by Taylor series in time.
- `newton`: the figure eight with the published initial values, and refined to any number of digits.
- `lemniscate`: three bodies on Bernoulli's lemniscate, under another force, in closed form.
"""
