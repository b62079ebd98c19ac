// Disk of 100 mm diameter and 10 mm thickness: triangles extruded to one layer of prisms.
// gmsh -3 -format msh41 disk.geo
R = 0.05;
t = 0.01;
h = 0.005;
Point(1) = {0, 0, 0, h};
Point(2) = {R, 0, 0, h};
Point(3) = {0, R, 0, h};
Point(4) = {-R, 0, 0, h};
Point(5) = {0, -R, 0, h};
Circle(1) = {2, 1, 3};
Circle(2) = {3, 1, 4};
Circle(3) = {4, 1, 5};
Circle(4) = {5, 1, 2};
Curve Loop(1) = {1, 2, 3, 4};
Plane Surface(1) = {1};
Point{1} In Surface{1};
solid[] = Extrude {0, 0, t} { Surface{1}; Layers{1}; Recombine; };
Physical Volume("rock") = {solid[1]};
Physical Surface("rim") = {solid[2], solid[3], solid[4], solid[5]};
Mesh.MshFileVersion = 4.1;
