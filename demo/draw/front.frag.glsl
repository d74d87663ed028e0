// First fibre of a light's map: depth alone.

void main()
{
    if (coverage() <= 0.0) {
        discard;
    }
}
