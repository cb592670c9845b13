r"""The comparison of coefficients as one writes it with SymPy alone: the book's yardstick.

With z = e^{iτ} a Fourier sum is an expression in z.  At each order the new coefficients are
symbols; the equations of that order are expanded, collected by powers of z and solved.
"""

import sympy as sp

z = sp.Symbol("z")


def cosine(n):
    return (z**n + z**-n) / 2 if n else sp.S.One


def derivative(f):
    """d/dτ."""
    return sp.expand(sp.I * z * sp.diff(f, z))


def cauchy(a, b, k, weight=lambda j: 1):
    """Σ_j weight(j) a_j b_{k-j}."""
    return sp.expand(sum(weight(j) * a[j] * b[k - j] for j in range(k + 1)))


def modes(f):
    """{n: the coefficient of z^n} of a Fourier sum."""
    found = {}
    for term in sp.Add.make_args(sp.expand(f)):
        c, n = term.as_coeff_exponent(z)
        found[int(n)] = found.get(int(n), 0) + c
    return found


def conditions(f):
    """What must vanish for f to vanish: f is even in τ."""
    return [c for n, c in modes(f).items() if n >= 0]


def solved(equations, symbols, *tables):
    """Put the solution of linear equations into the last entries of the tables."""
    (values,) = sp.linsolve(equations, symbols)
    known = dict(zip(symbols, values, strict=True))
    for table in tables:
        table[:] = [sp.expand(entry.subs(known)) if entry.free_symbols & set(symbols) else entry
                    for entry in table]


def duffing(order):
    """u and ω² of ω² u'' + u + ε u³ = 0 up to ε^order; the amplitude of cos τ is 1."""
    u, square = [cosine(1)], [sp.S.One]
    for k in range(1, order + 1):
        symbols = sp.symbols(f"w a3:{2 * k + 2}:2")
        square.append(symbols[0])
        u.append(sp.Add(*(a * cosine(n) for a, n in zip(symbols[1:], range(3, 2 * k + 2, 2)))))
        second = [derivative(derivative(f)) for f in u]
        cube = cauchy([cauchy(u, u, j) for j in range(k)], u, k - 1)
        residual = cauchy(square, second, k) + u[k] + cube
        solved(conditions(residual), symbols, u, square)
    return u, square


def eight(order):
    """r and φ of (E3a), (E3b) up to an odd power λ^order, lengths in 3^{1/3}."""
    r, phi = [sp.S.One, sp.S.Zero], [sp.S.Zero, cosine(1)]
    c, s, f = [sp.S.One], [sp.S.Zero], [sp.S.One]                # cos φ, sin φ, r^-2
    x, y = [], []                                                # the forces of the two others
    for k in range(0, order + 1, 2):
        symbols = []
        if k:
            symbols = sp.symbols(f"a0:{k + 1}:2 b3:{k + 2}:2")
            even, odd = symbols[:k // 2 + 1], symbols[k // 2 + 1:]
            r += [sp.Add(*(a * cosine(n) for a, n in zip(even, range(0, k + 1, 2)))), sp.S.Zero]
            phi += [sp.S.Zero, sp.Add(*(b * cosine(n) for b, n in zip(odd, range(3, k + 2, 2))))]
        for m in range(max(k, 1), k + 2):
            c.append(-cauchy(phi, s + [sp.S.Zero], m, lambda j: j) / m)
            s.append(cauchy(phi, c, m, lambda j: j) / m)
            f.append(cauchy(r, f + [sp.S.Zero], m, lambda j, m=m: -j - m) / m)
        for m in range(k, k + 2):
            x.append(neighbours(cauchy(f, c, m)))
            y.append(neighbours(cauchy(f, s, m)))
        if k:
            solved(conditions(radial(r, phi, c, s, f, x, y, k))
                   + conditions(angular(r, phi, c, s, x, y, k + 1)),
                   symbols, r, phi, c, s, f, x, y)
    return r, phi


def neighbours(f):
    """The sum of f over the phases shifted by thirds of a period."""
    return sp.Add(*(c * z**n * (-1 if n % 3 else 2) for n, c in modes(f).items()))


def radial(r, phi, c, s, f, x, y, k):
    velocity = [derivative(term) for term in phi]
    square = [cauchy(velocity, velocity, j) for j in range(k + 1)]
    return (derivative(derivative(r[k])) - cauchy(r, square, k)
            + (2 * f[k] - cauchy(c, x, k) - cauchy(s, y, k)) / 3)


def angular(r, phi, c, s, x, y, k):
    velocity = [derivative(term) for term in phi]
    return (cauchy(r, [derivative(v) for v in velocity], k)
            + 2 * cauchy([derivative(term) for term in r], velocity, k)
            + (cauchy(s, x, k) - cauchy(c, y, k)) / 3)
