"""Vertex groups with their weights."""
import collections

from .sentences import counted


def carry(source, target, along):
    """At vertices with a partner the target has the source's weights, exactly. Groups are found by name, or made."""
    if not source.vertex_groups:
        return []
    group_of = {}
    for group in source.vertex_groups:
        mine = target.vertex_groups.get(group.name)
        if mine is None:
            mine = target.vertex_groups.new(name=group.name)
            mine.lock_weight = group.lock_weight
        group_of[group.index] = mine
    here, there = along.vertices.T.tolist()
    write(target, group_of.values(), there, _weights(source, group_of, here))
    return [f"{counted(len(group_of), 'vertex group')}: {len(along.vertices):,} vertices"]


def write(obj, groups, vertices, weights):
    """Give vertices exactly these weights in these groups. weights: for each vertex {index of the group: weight}."""
    vertex_group = {group.index: group for group in groups}
    removed, added = collections.defaultdict(list), collections.defaultdict(list)
    for vertex, wanted in zip(vertices, weights):
        for element in obj.data.vertices[vertex].groups:
            if element.group in vertex_group and element.group not in wanted:
                removed[element.group].append(vertex)
        for group, weight in wanted.items():
            added[group, weight].append(vertex)
    for group, members in removed.items():
        vertex_group[group].remove(members)
    for (group, weight), members in added.items():
        vertex_group[group].add(members, weight, "REPLACE")


def _weights(source, group_of, vertices):
    """With the indices that the groups have in the target."""
    index = {theirs: mine.index for theirs, mine in group_of.items()}
    every = source.data.vertices
    return [{index[element.group]: element.weight for element in every[vertex].groups if element.group in index}
            for vertex in vertices]
