/* A loop without end. Costs processor time, never hangs the simulator. */
int main(void)
{
    for (;;)
        ;
}
