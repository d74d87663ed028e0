// A surface in a shadow map: depth alone.

void main()
{
}
