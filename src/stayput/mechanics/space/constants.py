"""Constants of the flow of a lone body (`stayput.mechanics.space.flow`), and of the engine beside it."""

MOST_PRESSING = 24
"""Most contacts that press in a flow: corners of a base with many, or of a box on the floor and walls. With
more the general law goes on.
"""

PRESSING_SHARE = 1e-6
"""Share of the weight from which on a contact presses: below it a force is what the solver leaves."""

MOST_ROWS = 3 * MOST_PRESSING
"""Most velocities that contacts forbid: all stick."""

MOST_INDEPENDENT, ON_MIXED_EDGE = 3, 4
"""Most rows that are taken to be independent: those of a corner that sticks, or of three that slip; and those
of an edge on the floor of which one corner sticks and the other slips, which are so too.
"""

SHARING, REFINEMENTS = 1e-6, 2
"""Share of the diagonal that is added so that contacts share where there are more than the body needs, and
solutions with it, each for what the last leaves: 1e-12 of the forces, with rounding of 1e-10.
"""

PRESSURE_ROUNDS = 6
"""Most rounds of forces and centre of pressure; two are usual, and what has not converged in six, as where a
contact would pull, rarely does.
"""

EXTRAPOLATED, NEAR_PRESSURE = 0.1, 1e-4
"""Part of the way between the centres of two rounds by which forces are extrapolated instead of found in a
third one, and how near the second has to be [m]: they are linear there to 1e-7.
"""

LEAST_RELAXATION, MOST_RELAXATION = 0.02, 4.0
"""Bounds of the factor on its change in each: a change may call for another against it, or along with it."""

PRESSURE_TOLERANCE = 1e-6
"""How far the centre of pressure may move in the last of them [m]: forces are exact to 1e-5 then."""

SLIP_BEGIN_SPEED, SLIP_END_SPEED = 2e-3, 1e-3
"""Least slip of a contact when a flow begins, and that at which it ends [m/s]. Across a slip u friction turns
it at the rate μ g/u, which is stiff below: there the general, implicit steps go on. The two are apart so that
a flow that begins does not end at once.
"""

PINNED_SPEED, PINNED_REST = 1e-4, 1e-9
"""Speed up to which a body on three contacts or more comes to rest [m/s], and what rounding leaves of it
where these hold it.
"""

FLOW_TOLERANCE = 0.1
"""Error of a step over its length, and over that of the longest plain one, up to which it is accepted [m/s²]:
1 µm in a sample of 10 ms. Ten times more saves hardly any time, and more falls are other ones.
"""

VELOCITY_ERROR_TIME = 0.01
"""Time for which an error of velocities is taken to last, beside one of places [s]."""

LONGEST_FLOW_STEP, SHORTEST_FLOW_STEP = 0.05, 0.1
"""Longest step [s], and the shortest, over the longest plain one. What needs shorter ones, such as a strong
damper, is stiff and left to the general law.
"""

STIFF_PAUSE = 8
"""General steps after a step that was stiff, before another flow is tried."""

SHORTEST_FLOW = 1e-8
"""Time to an event below which a flow is over before it begins [s]."""

STEP_SAFETY, LEAST_GROWTH, MOST_GROWTH = 0.9, 0.2, 4.0
"""Factors on the length of the next step: on the one that the error allows, and its bounds."""

MOST_STEP_TRIES = 16
"""Most lengths that a step is tried with."""

GAP_TOLERANCE = 5e-8
"""Gap up to which a point meets a plane, and how much deeper than at first it may go into one [m]: half of
the gap at which general steps close a contact.
"""

MARGIN_TOLERANCE = 1e-6
"""How far beyond the margin of its forces, over the weight, a flow ends."""

EVENT_TIME_TOLERANCE = 1e-9
"""How exactly the time of an event is found where neither of these is reached [s]."""

MOST_EVENT_LOOKS = 60
"""Most evaluations to find it; bisection alone takes 24 of 10 ms."""

SETTLED_GAP = 1e-9
"""Gap of a point of a body at rest up to which it is on the floor [m]: rounding, and what steps leave."""

SETTLE_GAP, SETTLE_SPEED = 1e-6, 3e-3
"""Gap and speed up to which corners beside one that lands slowly are stopped with it [m, m/s]: they would
rock and rebound without end, less each time.
"""

STEP_AFTER_EVENT = 0.02
"""Length of the general step after an event, which tells how it goes on, over the longest plain one: so short
that its error does not count.
"""

PLAIN_GROWTH, PLAIN_GROWTH_OF_SEVERAL = 8.0, 2.0
"""How many times as long as the last a plain step may be, of a lone body and of several. A lone one that does
not flow on after an event slips slowly, and needs no short steps for that.
"""

IMPULSE_TIME = 1e-3
"""Length of the step as of which forces of a flow are kept for the next general one [s]."""

DEVICE_LOSS_STEP = 0.25
"""Longest step in which a device is lost, over the longest plain one."""

DEVICE_STEP, SWITCH_STEP = 2.0, 1.0
"""Longest step in which a device yields or rubs from the beginning on, as what is plastic is counted at its
end; and what of a step may come after a device begins or ends to bear, to yield or to rub in it: of a force
that jumps the error of a step sees a hundredth. Both over the longest plain one.
"""

AFTER_SWITCH = 0.7
"""What of these lengths comes after the switch where a step is taken again to end there: when it happens is
estimated.
"""

YIELDS_ON = 0.1
"""Part of a step up to which a device that switches in it counts as if it had from its beginning."""

FLOW_WORK = 25.0
"""Work of a step on the budget of a run, in updates of a contact."""

SHORTEST, SHORTEST_OF_SEVERAL = 1e-7, 1e-6
"""Shortest step to where corners of a body alone meet planes; and to where rims or bodies do, which meet more
often: a rim that rolls and rebounds hits without end [s].
"""

LENGTH, EVENT, ROUGH, SHORT, LIMIT = range(5)
"""What a step passes on to the next: its length; that down to which one with an event is halved; plain steps
to come; shortest steps in a row, and their length.
"""
